package frustum.fixed

import frustum.spec.{SineTable, VoxelRules}
import spinal.core._

/** Sine of an angle in 1/1024 turns, 16 fraction bits, two clocks later; see [[frustum.spec.SineTable]]. */
case class SineLookup() extends Component {
  import SineTable._
  val io = new Bundle {
    val angle = in UInt (VoxelRules.AngleBits bits)
    val sine  = out SInt (Width bits)
  }
  val within  = io.angle(IndexBits - 1 downto 0)
  val falling = io.angle(IndexBits)
  val words   = Mem(UInt(FractionBits bits), quarter.map(U(_, FractionBits bits)))
  val word    = words.readSync(Mux(falling, U(0, IndexBits bits) - within, within))
  val one     = RegNext(falling && within === 0)
  val minus   = RegNext(io.angle.msb)
  val size    = Mux(one, U(1 << FractionBits, Width bits), word.resize(Width)).asSInt
  io.sine := RegNext(Mux(minus, -size, size))
}
