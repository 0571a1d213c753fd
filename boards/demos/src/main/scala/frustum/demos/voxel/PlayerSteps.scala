package frustum.demos.voxel

import frustum.arithmetic.SineLookup
import frustum.contract.arithmetic.SineTable
import frustum.demos.voxel.VoxelRules._
import spinal.core._

/** Sines of a player's pose, looked up one after the other while it `looks`, and the movement along x and y of the
  * buttons, which is valid a few cycles later.
  *
  * @param width of a coordinate
  */
class PlayerSteps(width: Int, pose: VoxelPose, buttons: VoxelButtons, looks: Bool) extends Area {
  val lookup = SineLookup()
  val sines = Reg(PlayerSines())
  private val last = SineLookup.Latency + sines.all.length
  private val count = Reg(UInt(log2Up(last + 1) bits))

  // In the order of the sines: a cosine is the sine of a quarter turn more.
  lookup.io.angle := Mux(count(1), pose.pitch.asUInt, pose.yaw) + Mux(count(0), U(0), U(Turn / 4, AngleBits bits))
  when(!looks)(count := 0) otherwise {
    count := count + 1
    for ((sine, i) <- sines.all.zipWithIndex) when(count === i + SineLookup.Latency)(sine := lookup.io.sine)
  }

  /** All sines are there. */
  val over = count === last

  /** Rounded to 8 fraction bits. */
  private def coarse(sine: SInt): SInt =
    RegNext((sine + (1 << SineTable.FractionBits - 9)) >> SineTable.FractionBits - 8)
  private def times(by: SInt, sine: SInt) =
    by.mux(S(1, 2 bits) -> sine.resize(11), S(-1, 2 bits) -> -sine.resize(11), default -> S(0, 11 bits))

  private val ahead = VoxelButtons.both(buttons.forward, buttons.back)
  private val aside = VoxelButtons.both(buttons.right, buttons.left)
  private val cos = coarse(sines.cosYaw)
  private val sin = coarse(sines.sinYaw)
  private val sums = Seq(
    RegNext(times(ahead, cos) +^ times(aside, sin)),
    RegNext(times(ahead, sin) -^ times(aside, cos))
  )

  /** Along x and y, 1/256 block. */
  val steps = Vec(sums.map(sum => RegNext((sum * S(WalkStep, 7 bits)) >> 8).resize(width)))
}
