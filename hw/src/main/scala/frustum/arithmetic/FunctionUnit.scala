package frustum.arithmetic

import frustum.contract.arithmetic.FunctionTable
import frustum.device.Tech
import spinal.core._

/** y = f(x) of 16 bits each, one per cycle, latency `FunctionUnit.Latency`: two memories of 256 x 16 and one
  * multiplier, which adds the line's step to its base. Error: see [[frustum.contract.arithmetic.FunctionTable]].
  */
case class FunctionUnit(table: FunctionTable, tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val x = in UInt (16 bits)
    val y = out UInt (16 bits)
  }
  private def words(w: Array[Int]) = Mem(Bits(16 bits), w.toSeq.map(B(_, 16 bits)))
  val bases = words(table.base)
  val slopes = words(table.slope)
  private val index = io.x(15 downto 8)
  val line = Multiplier16(tech, signedA = false, signedB = false, add = true, subtract = !table.rises)
  line.io.enable := True
  line.io.a := slopes.readSync(index)
  line.io.b := RegNext(io.x(7 downto 0)) ## B(0, 8 bits)
  line.io.addend := bases.readSync(index) ## B(0x8000, 16 bits)
  io.y := line.io.product(31 downto 16).asUInt
}

object FunctionUnit {
  val Latency = 1 + Multiplier16.Latency
}
