package frustum.raster.texture

import frustum.contract.raster.{RasterConfig, RenderState, TexelFormat, TextureRef, Wrap}
import frustum.device.Tech
import frustum.harness.{Equality, FrustumSim, Simulated}
import frustum.model
import frustum.raster.fragment.StateSim
import frustum.raster.store.RenderStateWord
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._
import spinal.lib.sim.StreamDriver

import scala.util.Random

/** The texture unit with coordinates held back until `go`, which comes when its memory is loaded. */
class TextureHarness(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(Stream(TextureCoordinate()))
    val go = in Bool ()
    val state = in(RenderStateWord())
    val texels = slave(Stream(TexelWrite()))
    val down = master(Stream(Texel()))
  }
  val unit = TextureUnit(config, Tech.Generic)
  unit.io.up << io.up.haltWhen(!io.go)
  unit.io.state := io.state
  unit.io.texels << io.texels
  io.down << unit.io.down
}

class TextureUnitTest extends AnyFunSuite with Simulated {
  private val config = RasterConfig(textureTexels = 4096)
  private lazy val unit = FrustumSim.compile("TextureUnit")(new TextureHarness(config))

  private def check(
      seed: Int,
      state: RenderState,
      coordinates: Seq[(Int, Int)],
      rewrite: Boolean = false
  ): Unit = {
    val random = new Random(seed)
    val texture = state.texture.get
    val texels = Array.fill(config.textureTexels)(random.nextInt(65536))
    val expected = coordinates.map { case (s, t) =>
      val address = model.raster.texture.TextureUnit.address(
        model.raster.texture.TextureUnit.index(s, state.wrapS, texture.log2Width),
        model.raster.texture.TextureUnit.index(t, state.wrapT, texture.log2Height),
        texture.base,
        texture.log2Width
      )
      model.raster.texture.TextureUnit.decode(texels(address), texture.format == TexelFormat.Rgba4444)
    }
    Equality(unit)(_.io.up, _.io.down)(
      (c: TextureCoordinate, v: (Int, Int)) => { c.s #= v._1; c.t #= v._2 },
      (x: Texel) => x.r.toInt << 16 | x.g.toInt << 10 | x.b.toInt << 5 | x.a.toInt
    ).run(
      coordinates,
      expected,
      seed,
      minThroughput = None,
      setup = dut => {
        StateSim.drive(dut.io.state, state)
        var loaded = 0 // in order, then the same contents again: the traffic must lose nothing
        dut.io.go #= false
        StreamDriver(dut.io.texels, dut.clockDomain) { p =>
          val i = if (loaded < texels.length) loaded else simRandom.nextInt(texels.length)
          p.address #= i
          p.data #= texels(i)
          loaded += 1
          if (loaded == texels.length + 1) dut.io.go #= true
          loaded <= texels.length || rewrite
        }.transactionDelay = () => if (loaded < texels.length) 0 else simRandom.nextInt(6)
      }
    )
  }

  private def anywhere(random: Random): (Int, Int) = {
    def one() = random.nextInt() >> 5 + random.nextInt(12)
    (one(), one())
  }

  for (seed <- 1 to 6) test(s"random states and coordinates, seed $seed") {
    val random = new Random(seed)
    check(seed, StateSim.random(random, 4096), Seq.fill(1000)(anywhere(random)))
  }
  for (wrap <- Wrap.all; log2 <- Seq(3, 5, 7)) test(s"$wrap at the borders, ${1 << log2} texels") {
    val borders = for (i <- -2 to 2; d <- Seq(-1, 0, 1)) yield (i << 17) + d
    val state = RenderState(Some(TextureRef(0, log2, 10 - log2, TexelFormat.Rgba4444)), wrap, wrap)
    check(7, state, (for (s <- borders; t <- borders) yield (s, t)) ++ Seq((-(1 << 26), (1 << 26) - 1)))
  }
  test("texels written while others are read") {
    val random = new Random(8)
    check(8, StateSim.random(random, 4096), Seq.fill(1000)(anywhere(random)), rewrite = true)
  }
}
