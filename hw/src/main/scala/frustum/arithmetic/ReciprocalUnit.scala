package frustum.arithmetic

import frustum.device.Tech
import spinal.core._

/** r = 2 f / (1 + f) of [[frustum.contract.arithmetic.ReciprocalTable]], by which 1 / (1 + f) = 1 - r / 2: one per
  * cycle of `enable`, latency [[ReciprocalUnit.Latency]], one multiplier and a memory of 256 x 32.
  */
case class ReciprocalUnit(tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val enable = in Bool ()
    val f = in UInt (20 bits) // 20 fraction bits
    val r = out Bits (16 bits) // in units of 2^-16
  }
  val line = ReciprocalLine.read(io.f, io.enable)
  val multiplier = Multiplier16(tech, signedA = false, signedB = false, add = true)
  multiplier.io.enable := io.enable
  multiplier.io.a := line.factor
  multiplier.io.b := RegNextWhen(ReciprocalLine.fraction(io.f), io.enable)
  multiplier.io.addend := line.addend
  io.r := ReciprocalLine.reciprocal(multiplier.io.product)
}

object ReciprocalUnit {
  val Latency: Int = ReciprocalLine.Latency + Multiplier16.Latency
}
