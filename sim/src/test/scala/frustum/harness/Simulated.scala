package frustum.harness

import org.scalatest.{Suite, SuiteMixin, Tag}

/** Marks a test that simulates with Verilator: `./sbt quick` leaves it out. A test that simulates without the mark
  * fails there.
  */
object Simulated extends Tag("frustum.harness.Simulated")

/** Marks every test of a suite as one that simulates. */
trait Simulated extends SuiteMixin { this: Suite =>
  abstract override def tags: Map[String, Set[String]] =
    testNames.map(name => name -> (super.tags.getOrElse(name, Set.empty) + Simulated.name)).toMap
}
