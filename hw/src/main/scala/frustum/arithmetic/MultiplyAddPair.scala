package frustum.arithmetic

import frustum.device.{Mac16, Tech}
import spinal.core._

/** Two of addend + a * b modulo 2^16, with a signed and b unsigned, 8 bits each; latency one cycle, one per cycle. On
  * iCE40 it is one SB_MAC16, whose result is not registered.
  */
case class MultiplyAddPair(tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val a = in Vec (SInt(8 bits), 2)
    val b = in Vec (UInt(8 bits), 2)
    val addend = in Vec (UInt(16 bits), 2)
    val result = out Vec (UInt(16 bits), 2)
  }

  tech match {
    case Tech.Ice40 =>
      val mac = Mac16(signedA = true, signedB = false, add = true, pair = true)
      mac.idle()
      mac.io.CE := True
      mac.io.A := io.a.asBits
      mac.io.B := io.b.asBits
      mac.io.C := io.addend(1).asBits
      mac.io.D := io.addend(0).asBits
      io.result.assignFromBits(mac.io.O)
    case _: Tech.Inferred =>
      for (i <- 0 to 1) {
        val product = RegNext(io.a(i)) * RegNext(io.b(i)).intoSInt
        io.result(i) := RegNext(io.addend(i)) + product.resize(16).asUInt
      }
  }
}
