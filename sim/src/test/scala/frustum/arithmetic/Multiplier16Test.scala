package frustum.arithmetic

import frustum.device.Tech
import frustum.harness.{Equality, FrustumSim}
import frustum.model
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.lib._

import scala.util.Random

/** Wraps the multiplier in a pipeline that stalls, as its users do. */
class MultiplierStream(signedA: Boolean, signedB: Boolean) extends Component {
  val io = new Bundle {
    val up = slave(Stream(Bits(32 bits)))
    val down = master(Stream(Bits(32 bits)))
  }
  val multiplier = Multiplier16(Tech.Generic, signedA, signedB)
  val valid = Vec.fill(Multiplier16.Latency)(RegInit(False))
  val move = !valid.last || io.down.ready
  multiplier.io.enable := move
  multiplier.io.a := io.up.payload(31 downto 16)
  multiplier.io.b := io.up.payload(15 downto 0)
  when(move) { valid(0) := io.up.valid; valid(1) := valid(0) }
  io.up.ready := move
  io.down.valid := valid.last
  io.down.payload := multiplier.io.product
}

class Multiplier16Test extends AnyFunSuite {
  for (signedA <- Seq(false, true); signedB <- Seq(false, true))
    test(
      s"product of ${if (signedA) "signed" else "unsigned"} and ${if (signedB) "signed" else "unsigned"}"
    ) {
      val random = new Random(1)
      val corners = Seq(0, 1, 0x7fff, 0x8000, 0xffff)
      val pairs =
        (for (a <- corners; b <- corners)
          yield (a, b)) ++ Seq.fill(1000)((random.nextInt(65536), random.nextInt(65536)))
      Equality(
        FrustumSim.compile(s"Multiplier16_${signedA}_$signedB")(new MultiplierStream(signedA, signedB))
      )(
        _.io.up,
        _.io.down
      )(
        (a: Bits, v: (Int, Int)) => { import spinal.core.sim._; a #= (v._1.toLong << 16) | v._2 },
        (b: Bits) => { import spinal.core.sim._; b.toLong.toInt }
      ).run(
        pairs,
        pairs.map { case (a, b) => model.arithmetic.Multiplier16(a, b, signedA, signedB) },
        seed = 1,
        minThroughput = Some(0.99)
      )
    }
}
