package frustum.raster.fragment

import spinal.core._
import spinal.lib._

/** Tells when what leaves the interlock breaks a promise: a fragment that follows another of its pixel within less than
  * two clocks, or three where they are blended; the end of a tile while the one before is not `done`.
  */
class InterlockWatch(out: Flow[ColoredFragment], blend: Bool, done: Bool) extends Area {
  private val address = out.payload.address
  val before = Vec.fill(2)(Reg(Flow(UInt(widthOf(address) bits))))
  before.foreach(_.valid init False)
  before(0).valid := out.valid && !out.tileEnd
  before(0).payload := address
  before(1) := before(0)
  private def meets(n: Int) = before(n).valid && before(n).payload === address
  val tooClose = out.valid && !out.tileEnd && (meets(0) || meets(1) && blend)

  val resolving = RegInit(False) clearWhen done setWhen (out.valid && out.tileEnd)
  val tooEarly = out.valid && out.tileEnd && resolving
}
