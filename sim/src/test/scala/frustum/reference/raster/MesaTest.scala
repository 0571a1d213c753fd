package frustum.reference.raster

import frustum.judge.{AttributeJudge, Passes}
import frustum.spec.{FramePass, PackedVertex, RasterConfig}
import org.scalatest.funsuite.AnyFunSuite
import java.io.{ByteArrayInputStream, ByteArrayOutputStream}
import java.nio.file.{Files, Path}
import java.util.Locale
import scala.sys.process._
import scala.util.Random

/** The reference against Mesa's llvmpipe, which works in float32 and snaps to 1/256 pixel: our vertices, on
  * 1/16, are on its grid as well. Skipped where libosmesa6-dev or a C compiler is missing.
  */
class MesaTest extends AnyFunSuite {
  private val seed   = 77L
  private val config = RasterConfig(width = 256, height = 192)

  private lazy val program: Option[Path] = {
    val folder = Files.createTempDirectory("mesa")
    Files.copy(getClass.getResourceAsStream("/mesa/draw.c"), folder.resolve("draw.c"))
    val command = Seq("gcc", "-O1", "-o", s"$folder/draw", s"$folder/draw.c", "-lOSMesa")
    val built   =
      try command.!(ProcessLogger(_ => ())) == 0
      catch { case _: java.io.IOException => false }
    Option.when(built)(folder.resolve("draw"))
  }

  /** Colours as 0xRRGGBB, rows from the top; colours of the vertices are given by `color`. */
  private def mesa(
      pass: FramePass,
      textured: Boolean
  )(color: (Int, PackedVertex) => Seq[Double]): Array[Int] = {
    val draw =
      program.getOrElse(cancel("Mesa is not here: install libosmesa6-dev and gcc for this cross-check"))
    val vertices = for ((t, n) <- pass.triangles.zipWithIndex; i <- Seq(t.v0, t.v1, t.v2)) yield {
      val v = ScreenVertex.of(pass.vertices(i))
      (Seq(v.x, v.y, v.z / 65535, v.q, v.s, v.t) ++ color(n, pass.vertices(i)))
        .map(d => "%.17g".formatLocal(Locale.ROOT, d)).mkString(" ")
    }
    val size  = s"${config.width} ${config.height} ${if (textured) 1 else 0} ${pass.triangles.length}"
    val input = (size +: vertices).mkString("\n")
    val out   = new ByteArrayOutputStream
    val run   = Process(
      Seq(draw.toString),
      None,
      "GALLIUM_DRIVER" -> "llvmpipe"
    ) #< new ByteArrayInputStream(input.getBytes) #> out
    val about = new StringBuilder
    assert(run.!(ProcessLogger(_ => (), line => about ++= line)) == 0, about)
    assert(about.toString.contains("llvmpipe"), about)
    val bytes = out.toByteArray
    Array.tabulate(config.width * config.height) { i =>
      val at = 4 * ((config.height - 1 - i / config.width) * config.width + i % config.width)
      (0 until 3).foldLeft(0)((c, k) => c << 8 | bytes(at + k) & 255)
    }
  }

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
    val r      = new Random(seed)
    def vertex = {
      val grid                = if (r.nextBoolean()) 8 else 1
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
    val pass  = soup(seed, 1000)
    val drawn =
      mesa(pass, textured = false)((n, _) => Seq((n + 1) / 256 / 255.0, (n + 1) % 256 / 255.0, 0, 1))
    val wrong = drawn.zip(last(pass)).count { case (color, n) => (color >> 8) - 1 != n }
    assert(wrong == 0, s"of ${drawn.length} pixels, seed $seed")
  }

  test("texels in perspective agree where they are judged") {
    val pass   = soup(seed + 1, 60)
    val drawn  = mesa(pass, textured = true)((_, _) => Seq(1, 1, 1, 1))
    val planes = pass.triangles.map(t =>
      new TriangleAttributes(IndexedSeq(t.v0, t.v1, t.v2).map(i => ScreenVertex.of(pass.vertices(i))))
    )
    val verdicts = for (
      (n, i) <- last(pass).zipWithIndex if n >= 0;
      v      <- AttributeJudge.one(
        pass.states.head,
        planes(n)(i % config.width, i / config.width),
        drawn(i) >> 20 & 15,
        drawn(i) >> 12 & 15
      )
    ) yield v
    val sum = verdicts.reduce(_ + _)
    assert(sum.judged > 20000 && sum.wrong <= sum.judged / 500, s"$sum, seed $seed")
  }
}
