package frustum.reference.raster

import frustum.contract.raster.{FramePass, RasterConfig, RenderState}
import java.util.Locale

/** Mesa's llvmpipe, off-screen, as a referee: another renderer, in float32, that snaps to 1/256 pixel, so that our
  * vertices, on 1/16, are on its grid as well.
  *
  * @param program `draw.c` of the resources
  */
final class Mesa(program: MesaProgram) {

  /** Index of the triangle that shows at each pixel, rows from the top, -1 where there is none.
    *
    * @param depth by the depth test of the states; otherwise the last one shows
    */
  def triangles(pass: FramePass, config: RasterConfig, depth: Boolean): Array[Int] =
    draw(pass, config, textured = false, depth).map(_ - 1)

  /** Texel that shows at each pixel as (s, t), None where nothing does. Every triangle counts as textured. */
  def texels(pass: FramePass, config: RasterConfig, depth: Boolean): Array[Option[(Int, Int)]] =
    draw(pass, config, textured = true, depth).map(c => Option.when((c & 255) != 0)((c >> 16, c >> 8 & 255)))

  private def draw(pass: FramePass, config: RasterConfig, textured: Boolean, depth: Boolean): Array[Int] = {
    val lines = pass.triangles.zipWithIndex.flatMap { case (t, n) =>
      words(pass.states(t.state)) +: Seq(t.v0, t.v1, t.v2).map { i =>
        val v = ScreenVertex.of(pass.vertices(i))
        Seq(v.x, v.y, v.z / ScreenVertex.DepthMax, v.q, v.s, v.t)
          .map(d => "%.17g".formatLocal(Locale.ROOT, d)).mkString(" ") + s" ${n + 1}"
      }
    }
    def flag(b: Boolean) = if (b) 1 else 0
    val size = s"${config.width} ${config.height} ${flag(textured)} ${flag(depth)} ${pass.triangles.length}"
    val bytes = program.run((size +: lines).mkString("\n"))
    Array.tabulate(config.width * config.height) { i =>
      val at = 4 * ((config.height - 1 - i / config.width) * config.width + i % config.width)
      (0 until 3).foldLeft(0)((c, k) => c << 8 | bytes(at + k) & 255)
    }
  }

  private def words(s: RenderState): String = {
    val (w, h) = s.texture.fold((3, 3))(t => (t.log2Width, t.log2Height))
    val flags = Seq(s.depth.less, s.depth.equal, s.depth.greater, s.depthWrite).map(if (_) 1 else 0)
    (Seq(w, h, s.wrapS.code, s.wrapT.code) ++ flags).mkString(" ")
  }
}

object Mesa {
  val Missing = "Mesa is not here: install libosmesa6-dev and gcc for this cross-check"

  /** None where Mesa or a C compiler is missing. */
  lazy val found: Option[Mesa] = MesaProgram.compiled("draw").map(new Mesa(_))
}
