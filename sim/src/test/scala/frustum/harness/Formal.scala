package frustum.harness

import org.scalatest.Tag

/** Marks tests that prove instead of trying: `testOnly * -- -n frustum.harness.Formal` runs them alone,
  * `-l` all others, and `./sbt quick` leaves them out.
  */
object Formal extends Tag("frustum.harness.Formal")
