package frustum.video

import frustum.contract.video.ColorFormat
import spinal.core._
import spinal.lib._

/** Pixels for a monitor, one per cycle of the pixel's rate (the core's, or, behind a source that divides it, every few
  * of those): colour (0 outside of `active`), sync pulses of the mode's polarity, and which cycles are visible.
  */
case class VideoBus(format: ColorFormat) extends Bundle with IMasterSlave {
  val red = UInt(format.red bits)
  val green = UInt(format.green bits)
  val blue = UInt(format.blue bits)
  val hSync, vSync, active = Bool()
  def asMaster(): Unit = out(red, green, blue, hSync, vSync, active)
}
