package frustum.demos.pad

import spinal.core._

/** The state of a console's pad, buttons high where pressed.
  *
  * @note sticks are 0 (left, up) to 255, 128 in the middle, also for a pad without sticks. Without a pad everything is
  *       at rest.
  */
case class PadState() extends Bundle {
  val connected = Bool()
  // in the order of the wire, first bit first
  val select, l3, r3, start, up, right, down, left = Bool()
  val l2, r2, l1, r1, triangle, circle, cross, square = Bool()
  val rightX, rightY, leftX, leftY = UInt(8 bits)

  def buttons: Seq[Bool] =
    Seq(select, l3, r3, start, up, right, down, left, l2, r2, l1, r1, triangle, circle, cross, square)
  def sticks: Seq[UInt] = Seq(rightX, rightY, leftX, leftY)

  def rest(): Unit = {
    connected := False
    buttons.foreach(_ := False)
    sticks.foreach(_ := 128)
  }
}
