package frustum.demos.voxel

import frustum.demos.pad.PadState
import spinal.core._

/** The inputs of a player of a voxel world. */
case class VoxelButtons() extends Bundle {
  val forward, back, left, right, up, down = Bool()
  val turnLeft, turnRight, lookUp, lookDown = Bool()
  val next, previous, place, destroy = Bool()
}

object VoxelButtons {

  /** 1, -1, or 0 where neither or both of two buttons are held. */
  def both(plus: Bool, minus: Bool): SInt =
    (plus && !minus).asUInt.resize(2).asSInt - (minus && !plus).asUInt.resize(2).asSInt

  /** A stick counts when it is this far from its middle. */
  val Tilt = 48

  /** The inputs from a console's pad: cross and circle up and down, R2 destroys, L2 places, L1 and R1 change the item.
    * The left stick walks, the right one looks; without sticks the cross of arrows walks and turns, triangle and square
    * look up and down.
    */
  def of(pad: PadState): VoxelButtons = {
    val b = VoxelButtons()
    def low(stick: UInt) = stick < 128 - Tilt
    def high(stick: UInt) = stick > 128 + Tilt
    b.forward := pad.up || low(pad.leftY)
    b.back := pad.down || high(pad.leftY)
    b.left := low(pad.leftX)
    b.right := high(pad.leftX)
    b.turnLeft := pad.left || low(pad.rightX)
    b.turnRight := pad.right || high(pad.rightX)
    b.lookUp := pad.triangle || low(pad.rightY)
    b.lookDown := pad.square || high(pad.rightY)
    b.up := pad.cross
    b.down := pad.circle
    b.next := pad.r1
    b.previous := pad.l1
    b.place := pad.l2
    b.destroy := pad.r2
    b
  }
}
