package frustum.arithmetic

import frustum.device.Tech
import frustum.harness.{Equality, FrustumSim, Simulated}
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

/** All four kinds in one model. */
class MultiplierStreams(kinds: Seq[(Boolean, Boolean)]) extends Component {
  val io = new Bundle {
    val up = Vec(kinds.map(_ => slave(Stream(Bits(32 bits)))))
    val down = Vec(kinds.map(_ => master(Stream(Bits(32 bits)))))
  }
  for (((signedA, signedB), i) <- kinds.zipWithIndex) {
    val unit = new MultiplierStream(signedA, signedB)
    unit.io.up << io.up(i)
    io.down(i) << unit.io.down
  }
}

class Multiplier16Test extends AnyFunSuite with Simulated {
  private val kinds = for (signedA <- Seq(false, true); signedB <- Seq(false, true)) yield (signedA, signedB)
  private lazy val compiled = FrustumSim.compile("Multiplier16")(new MultiplierStreams(kinds))

  for (((signedA, signedB), i) <- kinds.zipWithIndex)
    test(
      s"product of ${if (signedA) "signed" else "unsigned"} and ${if (signedB) "signed" else "unsigned"}"
    ) {
      val random = new Random(1)
      val corners = Seq(0, 1, 0x7fff, 0x8000, 0xffff)
      val pairs =
        (for (a <- corners; b <- corners)
          yield (a, b)) ++ Seq.fill(1000)((random.nextInt(65536), random.nextInt(65536)))
      Equality(compiled)(
        _.io.up(i),
        _.io.down(i)
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
