package frustum.arithmetic

import spinal.core._
import spinal.lib.misc.pipeline._

/** A row of pipeline nodes that all move on the same `enable` (the last node's ready), so that memories and multipliers
  * with a single enable can be between them. Bubbles do not collapse: the receiver must not wait for valid before it
  * gives ready.
  *
  * @param stages
  *   register stages, one less than there are nodes
  */
class LockstepPipeline(stages: Int) extends Area {
  val nodes = List.fill(stages + 1)(Node())

  def apply(i: Int): Node = nodes(i)
  def enable: Bool = nodes.head.isReady
  def anyValid: Bool = nodes.tail.map(_.isValid).reduce(_ || _)

  /** To be called when all nodes are described. */
  def build(): Unit =
    Builder(nodes.zip(nodes.tail).map { case (up, down) => StageLink(up, down).withoutCollapse() })
}
