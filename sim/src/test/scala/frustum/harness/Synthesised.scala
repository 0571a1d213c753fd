package frustum.harness

import org.scalatest.Tag

/** Marks tests that run yosys, which may have to be fetched first: `./sbt quick` leaves them out. */
object Synthesised extends Tag("frustum.harness.Synthesised")
