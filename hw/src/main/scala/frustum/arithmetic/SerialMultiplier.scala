package frustum.arithmetic

import spinal.core._
import spinal.lib._

/** a b of two's complement numbers, exact, by adding and shifting, without a multiplier. `start` takes the operands,
  * which must hold until `done` pulses, as many cycles later as b has bits; the product then holds until the next
  * start.
  */
case class SerialMultiplier(widthA: Int, widthB: Int) extends Component {
  val io = new Bundle {
    val start = in Bool ()
    val a = in SInt (widthA bits)
    val b = in SInt (widthB bits)
    val done = out Bool ()
    val product = out SInt (widthA + widthB bits)
  }
  val busy = RegInit(False)
  val bit = Counter(widthB)
  val high = Reg(SInt(widthA bits))
  val low = Reg(UInt(widthB bits)) // bits of the product from the top, remaining bits of b at the bottom
  val last = bit === widthB - 1
  val sum = SInt(widthA + 1 bits)
  sum := high.resized
  when(low.lsb)(sum := Mux(last, high -^ io.a, high +^ io.a))
  when(io.start) {
    busy := True
    high := 0
    low := io.b.asUInt
    bit.clear()
  } elsewhen (busy) {
    high := sum >> 1
    low := (sum.lsb ## low(widthB - 1 downto 1)).asUInt
    bit.increment()
    when(last)(busy := False)
  }
  io.done := RegNext(busy && last && !io.start) init False
  io.product := (high ## low).asSInt
}
