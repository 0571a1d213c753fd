package frustum.reference.raster

import frustum.contract.raster.{FramePass, RasterConfig, Wrap}
import frustum.driver.raster.{DrawOptions, Driver}
import frustum.engine.raster.RasterEngines
import frustum.judge.{AttributeJudge, FrameJudge, MesaJudge, Passes}
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** The reference against Mesa's llvmpipe, which works in float32 and snaps to 1/256 pixel: our vertices, on
  * 1/16, are on its grid as well. Skipped where libosmesa6-dev or a C compiler is missing.
  */
class MesaTest extends AnyFunSuite {
  private val seed = 77L
  private val config = RasterConfig(width = 256, height = 192)

  private lazy val mesa = Mesa.found.getOrElse(cancel(Mesa.Missing))

  /** The triangle that shows at each pixel when all are drawn in order without a depth test, -1 where there
    * is none.
    */
  private def last(pass: FramePass): Array[Int] = {
    val top = Array.fill(config.width * config.height)(-1)
    for ((c, n) <- ExactCoverage.of(pass).zipWithIndex)
      c.foreach(PixelRect.screen(config))((x, y) => top(y * config.width + x) = n)
    top
  }

  /** Clockwise triangles on the screen, where Mesa has nothing to clip; half of the vertices on centres or
    * corners of pixels, so that edges meet centres exactly.
    */
  private def soup(seed: Long, count: Int): FramePass = {
    val r = new Random(seed)
    def vertex = {
      val grid = if (r.nextBoolean()) 8 else 1
      def position(size: Int) = r.nextInt(size * 16 / grid) * grid / 16.0
      Passes.vertex(
        position(config.width),
        position(config.height),
        r.nextInt(65536),
        0.5 + r.nextDouble() * 8,
        r.nextDouble() * 4,
        r.nextDouble() * 4
      )
    }
    val triangles = Iterator.continually(Seq.fill(3)(vertex)).filter(ExactCoverage.of(_).doubleArea > 0)
    Passes.pass(Seq(Passes.textured), triangles.take(count).map(v => (0, v)).toSeq: _*)
  }

  test("coverage agrees, pixel for pixel") {
    val pass = soup(seed, 1000)
    val drawn = mesa.triangles(pass, config, depth = false)
    val wrong = drawn.zip(last(pass)).count { case (a, b) => a != b }
    assert(wrong == 0, s"of ${drawn.length} pixels, seed $seed")
  }

  test("texels in perspective agree where they are judged") {
    val pass = soup(seed + 1, 60)
    val drawn = mesa.texels(pass, config, depth = false)
    val planes = pass.triangles.map(t =>
      new TriangleAttributes(IndexedSeq(t.v0, t.v1, t.v2).map(i => ScreenVertex.of(pass.vertices(i))))
    )
    val verdicts = for {
      (n, i) <- last(pass).zipWithIndex if n >= 0
      (s, t) <- drawn(i)
      verdict <- AttributeJudge.one(pass.states.head, planes(n)(i % config.width, i / config.width), s, t)
    } yield verdict
    val sum = verdicts.reduce(_ + _)
    assert(sum.judged > 20000 && sum.wrong <= sum.judged / 500, s"$sum, seed $seed")
  }

  test(
    "of every scene the model shows the same triangles and texels, but for depths and texels that lie close"
  ) {
    val judge = new FrameJudge(RasterEngines.model, simulated = false)
    for (name <- Scenes.names) {
      val scene = Scenes.byName(name)
      val options = DrawOptions(None, cullBack = false, Wrap.Repeat, scene.background)
      val frame = Driver.prepare(scene, scene.camera, options, config, 0)
      for (v <- MesaJudge.judge(mesa, frame, judge.drawModel(frame)._3)) {
        info(s"$name: $v")
        assert(v.primitiveWrong <= 20 && v.wrong <= 1 + v.judged / 1000, s"$name: $v")
        assert(v.judged > 1000 || scene.materials.forall(_.texture.isEmpty), s"$name: $v")
      }
    }
  }
}
