package frustum.raster.fragment

import frustum.contract.raster.{Combine => CombineMode, RasterConfig, RenderState, TexelFormat, TextureRef}
import frustum.device.Tech
import frustum.harness.{Equality, FrustumSim, Simulated}
import frustum.model
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

class CombineTest extends AnyFunSuite {
  private case class Inputs(texel: Seq[Int], color: Seq[Int])
  private lazy val unit = FrustumSim.compile("Combine")(Combine(RasterConfig(), Tech.Generic))

  test("the model's product rounds to nearest but one part in 255, and is exact at both ends") {
    for (bits <- Seq(5, 6); t <- 0 until 1 << bits) {
      assert(model.raster.fragment.Combine.channel(t, 255) == t)
      assert(model.raster.fragment.Combine.channel(t, 0) == 0)
      for (c <- 0 to 255) {
        val error = model.raster.fragment.Combine.channel(t, c) - t * c / 255.0
        assert(error.abs <= 0.5 + t / 510.0, s"$t * $c / 255 is off by $error")
      }
    }
  }

  for (
    mode <- Seq(CombineMode.ColorOnly, CombineMode.Replace, CombineMode.Modulate);
    format <- Seq(TexelFormat.Rgb565, TexelFormat.Rgba4444)
  )
    test(s"$mode, $format", Simulated) {
      val random = new Random(1)
      val state = RenderState(Some(TextureRef(0, 3, 3, format)), combine = mode)
      val rgba = format == TexelFormat.Rgba4444
      def texel(five: Int, six: Int) = Seq(five, six, five, if (rgba) five else 31)
      val corners =
        for (t <- Seq(0, 1, 62, 63); c <- Seq(0, 1, 127, 128, 254, 255))
          yield Inputs(texel(t / 2, t), Seq.fill(4)(c))
      val inputs = corners ++ Seq.fill(2000)(
        Inputs(texel(random.nextInt(32), random.nextInt(64)), Seq.fill(4)(random.nextInt(256)))
      )
      val expected = inputs.map { in =>
        (0 until 4).map { i =>
          val keeps = mode == CombineMode.Replace && (i < 3 || rgba)
          val t = if (mode == CombineMode.ColorOnly) (if (i == 1) 63 else 31) else in.texel(i)
          model.raster.fragment.Combine.channel(t, if (keeps) 255 else in.color(i))
        }
      }
      Equality(unit)(_.io.up, _.io.down)(
        (p: TexturedFragment, in: Inputs) => {
          p.attributes.tileEnd #= false
          for ((signal, v) <- Seq(p.texel.r, p.texel.g, p.texel.b, p.texel.a).zip(in.texel)) signal #= v
          val colors = Seq(p.attributes.r, p.attributes.g, p.attributes.b, p.attributes.a)
          for ((signal, v) <- colors.zip(in.color)) signal #= v
        },
        (p: ColoredFragment) => IndexedSeq(p.r.toInt, p.g.toInt, p.b.toInt, p.a.toInt)
      ).run(
        inputs,
        expected,
        seed = 1,
        minThroughput = Some(0.99),
        setup = dut => StateSim.drive(dut.io.state, state)
      )
    }
}
