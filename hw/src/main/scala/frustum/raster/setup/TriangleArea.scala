package frustum.raster.setup

import frustum.contract.raster.SetupWords
import spinal.core._
import spinal.lib._

/** Twice the area of the triangle that is set up, shifted left a bit per cycle until bit 29 is set, or by
  * [[frustum.contract.raster.SetupWords.MaxShift]].
  *
  * @param result of the set-up engine
  * @param code   of the area's word among its results
  */
class TriangleArea(result: Flow[SetupResult], code: Int) extends Area {
  val value = Reg(UInt(30 bits))
  val backward = Reg(Bool()) // the triangle faces away
  val place = Reg(UInt(5 bits)) // 30 less the shift, or less that of the gradients
  val sliver = Reg(Bool()) // the gradients are too steep for fractions
  when(result.valid && result.target === code) {
    value := result.value.asUInt.resized
    backward := result.value.msb
  }
  val nothing = RegNext(backward || value === 0) // nothing of the triangle is drawn
  val normal = value.msb || place === 30 - SetupWords.MaxShift

  def start(): Unit = {
    sliver := False
    place := 30
  }

  def shift(): Unit = {
    value := value |<< 1
    place := place - 1
  }

  /** From the area's shift to that of the gradients, four bits further, and from there to that of a sliver's, 14 bits
    * less.
    */
  def toGradients(): Unit = place := Mux(sliver, place + 14, place - 4)
}
