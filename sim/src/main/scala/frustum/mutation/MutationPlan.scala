package frustum.mutation

import spinal.core.Component

/** What a unit's ports get in a clock, and what some of them must show in it.
  *
  * @param inputs,expect by port; inputs that are absent are 0
  * @param waits whether it lasts until the plan's `waitsFor` is high
  */
final case class MutationStep(
    inputs: Map[String, BigInt],
    expect: Map[String, BigInt] = Map.empty,
    waits: Boolean = false
)

/** How a unit is put to the test, in clocks, by values that its model gives: what its suite of random and corner inputs
  * does, as data, so that thousands of runs need no more than one simulation.
  *
  * @param waitsFor  the port that steps wait for
  * @param stalled   inputs that are high three times of four, by lot
  * @param event     ports that are high when a value leaves, and the ports that it is read from
  * @param events    what must leave, in this order; None where it is of no matter
  * @param busy      the port that tells whether anything is inside, where what enters leaves in the end
  */
final case class MutationPlan(
    name: String,
    unit: () => Component,
    steps: IndexedSeq[MutationStep],
    waitsFor: Option[String] = None,
    stalled: Seq[String] = Nil,
    event: Option[(Seq[String], Seq[String])] = None,
    events: IndexedSeq[Seq[Option[BigInt]]] = IndexedSeq.empty,
    busy: Option[String] = None
)

object MutationPlan {

  /** Port values from numbers. */
  def values(ports: (String, Long)*): Map[String, BigInt] = ports.map { case (name, v) =>
    name -> BigInt(v)
  }.toMap
}
