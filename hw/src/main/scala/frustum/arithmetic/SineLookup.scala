package frustum.arithmetic

import frustum.contract.arithmetic.SineTable
import spinal.core._
import spinal.lib._

/** Sine of an angle in 1/1024 turns, 16 fraction bits, latency [[SineLookup.Latency]] cycles; see
  * [[frustum.contract.arithmetic.SineTable]].
  */
case class SineLookup() extends Component {
  import SineTable._
  val io = new Bundle {
    val angle = in UInt (AngleBits bits)
    val sine = out SInt (Width bits)
  }
  val within = io.angle(IndexBits - 1 downto 0)
  val falling = io.angle(IndexBits)
  val words = Mem(UInt(FractionBits bits), quarter.map(U(_, FractionBits bits)))
  val word = words.readSync(RegNext(Mux(falling, U(0, IndexBits bits) - within, within)))
  val one = Delay(falling && within === 0, 2)
  val minus = Delay(io.angle.msb, 2)
  val size = Mux(one, U(1 << FractionBits, Width bits), word.resize(Width)).asSInt
  io.sine := RegNext(Mux(minus, -size, size))
}

object SineLookup {
  val Latency = 3
}
