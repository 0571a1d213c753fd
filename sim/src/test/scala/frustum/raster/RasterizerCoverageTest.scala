package frustum.raster

import frustum.contract.raster.{FramePass, RasterConfig}
import frustum.judge.{CoverageJudge, LoggedFragment}
import frustum.model.raster.{Rasterizer, ScreenFragments}
import frustum.reference.raster.ExactCoverage
import org.scalatest.funsuite.AnyFunSuite

import scala.collection.mutable.ArrayBuffer
import scala.util.Random

/** Which pixels the bit-exact set-up and walker cover, against the exact judge: not one may differ. [[RasterizerTest]]
  * holds the hardware to the model on the same kinds of triangles.
  */
class RasterizerCoverageTest extends AnyFunSuite {
  private val seed = 5

  /** The pixels each triangle of a pass covers, by the model. */
  private def drawn(config: RasterConfig, pass: FramePass): ArrayBuffer[LoggedFragment] = {
    val log = ArrayBuffer.empty[LoggedFragment]
    Rasterizer(config).draw(
      pass,
      new ScreenFragments(config)(f => log += LoggedFragment(f.triangle, f.x, f.y, 0, 0, 0))
    )
    log
  }

  private def wrong(config: RasterConfig, pass: FramePass): Long =
    CoverageJudge.judge(pass, drawn(config, pass), config).wrong

  test("10,000 hard triangles: no pixel wrong") {
    val config = RasterConfig(width = 128, height = 96)
    val hard = new HardTriangles(config, new Random(seed))
    val batch = 10 * hard.kinds.size
    val passes = Iterator.fill((10000 + batch - 1) / batch)(hard.pass(batch))
    val total = passes.zipWithIndex.foldLeft(CoverageJudge.Clean) { case (sum, (pass, n)) =>
      val verdict = CoverageJudge.judge(pass, drawn(config, pass), config)
      if (verdict.wrong != 0) {
        val one = pass.triangles.indices.find { i =>
          wrong(config, pass.copy(triangles = IndexedSeq(pass.triangles(i)))) != 0
        }
        val what = one.map { i =>
          val t = pass.triangles(i)
          s"triangle $i (${hard.kinds(i % hard.kinds.size)._1}) ${Seq(t.v0, t.v1, t.v2).map(pass.vertices)}"
        }
        fail(s"seed $seed, batch $n: $verdict, ${what.getOrElse("only all together")}")
      }
      sum + verdict
    }
    info(s"${total.covered} pixels covered")
    assert(total.covered > 1000000)
  }

  for (config <- Seq(RasterConfig(64, 48, 3, 3), RasterConfig(128, 96), RasterConfig(97, 65, 5, 4)))
    test(
      s"meshes cover each pixel once, ${config.width} x ${config.height}, tiles of ${config.tileWidth} x " +
        s"${config.tileHeight}"
    ) {
      val hard = new HardTriangles(config, new Random(seed))
      val (w, h) = (16 * config.width + 152, 16 * config.height + 152)
      val corners = Seq((-168, -168), (w, -168), (w, h), (-168, h)) // pixel centres
      val screen = Seq(Seq(corners(0), corners(1), corners(2)), Seq(corners(0), corners(2), corners(3)))
      val island = Seq(Seq(
        (16 * config.width - 23, 37),
        (16 * config.width - 75, 16 * config.height - 99),
        (11, 16 * config.height / 2 + 8)
      ))
      for ((outline, count) <- Seq(screen -> 40, screen -> 400, island -> 200)) {
        val pass = hard.meshPass(hard.mesh(outline, count).map(_.map(hard.vertex)))
        val expected = ExactCoverage.additiveCount(
          ExactCoverage.of(hard.meshPass(outline.map(_.map(hard.vertex)).toIndexedSeq)),
          config
        )
        if (outline == screen) assert(expected.forall(_ == 1))
        val got = new Array[Int](config.width * config.height)
        drawn(config, pass).foreach(f => got(f.y * config.width + f.x) += 1)
        val bad = got.indices.filter(i => got(i) != expected(i))
        if (bad.nonEmpty) fail(s"seed $seed, $count triangles: ${bad.size} pixels, first ${bad.headOption.map(
            i => (i % config.width, i / config.width, got(i))
          )}")
        assert(wrong(config, pass) == 0)
      }
    }
}
