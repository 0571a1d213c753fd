package frustum.raster.setup

import frustum.contract.raster.SetupInstruction._
import frustum.raster.scan.{Coefficient, CoefficientWrite}
import spinal.core._
import spinal.lib._

/** Turns the set-up engine's gradients and first values into the interpolator's coefficients, one write per cycle: a
  * horizontal gradient becomes a step to the right and one to the left, the latter as a complement, to which the
  * interpolator adds the missing one.
  */
case class CoefficientWriter(slots: Int) extends Component {
  val io = new Bundle {
    val result = slave(Flow(SetupResult()))
    val slot = in UInt (log2Up(slots) bits)
    val parity = in Bool ()
    val write = master(Flow(CoefficientWrite(slots)))
  }

  val value = Reg(SInt(32 bits))
  val plane = Reg(UInt(3 bits))
  val entry = Reg(UInt(3 bits))
  val both = RegInit(False) // the step to the left follows
  val writing = RegInit(False)
  io.write.valid := writing
  io.write.plane := plane
  io.write.slot := io.slot
  io.write.entry := entry
  io.write.value := value

  writing := both
  both := False
  when(both) {
    entry := Coefficient.Left
    value := ~value
  }
  when(io.result.valid) {
    def begin(kind: Result, at: UInt, mirrored: Boolean): Unit = when(io.result.kind === kind.code) {
      writing := True
      value := io.result.value
      plane := io.result.target.resized
      entry := at
      both := Bool(mirrored)
    }
    begin(GradientX(0), U(Coefficient.Right, 3 bits), mirrored = true)
    begin(GradientY(0), U(Coefficient.Down, 3 bits), mirrored = false)
    begin(Initial(0), io.parity.asUInt.resize(3), mirrored = false)
  }
}
