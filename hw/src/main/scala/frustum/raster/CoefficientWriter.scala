package frustum.raster

import frustum.spec.SetupInstruction._
import spinal.core._
import spinal.lib._

/** Turns the set-up engine's gradients and first values into the interpolator's coefficients, one write a clock: a
  * horizontal gradient becomes one step and four steps to either side, those to the left as complements, to which the
  * interpolator adds the missing one.
  */
case class CoefficientWriter(slots: Int) extends Component {
  val io = new Bundle {
    val result = slave Flow (SetupResult())
    val slot   = in UInt (log2Up(slots) bits)
    val parity = in Bool ()
    val write  = master Flow (CoefficientWrite(slots))
  }

  val value   = Reg(SInt(32 bits))
  val plane   = Reg(UInt(3 bits))
  val entry   = Reg(UInt(3 bits))
  val more    = Reg(UInt(2 bits)) init 0
  val writing = RegInit(False)
  io.write.valid := writing
  io.write.plane := plane
  io.write.slot := io.slot
  io.write.entry := entry
  io.write.value := value

  writing := more =/= 0
  when(more =/= 0) {
    more := more - 1
    entry := entry + 1
    value := (more === 2) ? (value(29 downto 0) @@ S(-1, 2 bits)) | ~value // right, left, left by four, right by four
  }
  when(io.result.valid) {
    def begin(kind: Result, at: UInt, followers: Int): Unit = when(io.result.kind === kind.code) {
      writing := True
      value := io.result.value
      plane := io.result.target.resized
      entry := at
      more := followers
    }
    begin(GradientX(0), U(Coefficient.Right, 3 bits), 3)
    begin(GradientY(0), U(Coefficient.Down, 3 bits), 0)
    begin(Initial(0), io.parity.asUInt.resize(3), 0)
  }
}
