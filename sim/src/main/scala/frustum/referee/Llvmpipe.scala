package frustum.referee

import frustum.contract.raster.{Combine, Wrap}
import frustum.driver.scene.{Material, MeshVertex, TextureImage}
import frustum.reference.raster.MesaProgram
import java.util.Locale

/** A picture drawn by Mesa's llvmpipe from the world: its own matrices, lighting, clipping, culling, texturing and
  * depth, in float32. Positions are given as seen from the eye, so that float32 holds them wherever the scene lies.
  *
  * @param seen    by drawings with triangle numbers, and with texel numbers, in place of colours
  * @param picture 0xRRGGBB, rows from the top
  */
final case class Llvmpipe(seen: Seen, picture: Array[Int])

object Llvmpipe {
  val Name = "llvmpipe"

  private lazy val program: Option[MesaProgram] = MesaProgram.compiled("world")

  /** None where Mesa or a C compiler is missing. */
  def draw(view: WorldView): Option[Llvmpipe] = program.map { mesa =>
    val bytes = mesa.run(input(view))
    val pixels = view.width * view.height
    require(bytes.length == 5 * 4 * pixels, s"llvmpipe drew ${bytes.length} bytes")

    /** Red, green and blue of a pixel of drawing `n`, whose rows come from the bottom. */
    def word(n: Int, at: Int): Int = {
      val row = view.height - 1 - at / view.width
      val from = 4 * ((n * view.height + row) * view.width + at % view.width)
      (0 until 3).foldLeft(0)((c, k) => c << 8 | bytes(from + k) & 255)
    }
    val seen = new Seen(pixels)
    for (at <- 0 until pixels) {
      seen.opaque(at) = word(1, at) - 1
      seen.opaqueTexel(at) = texel(word(2, at))
      seen.top(at) = word(3, at) - 1
      seen.topTexel(at) = texel(word(4, at))
    }
    Llvmpipe(seen, Array.tabulate(pixels)(word(0, _)))
  }

  /** Red s, green t, blue 255 where there is a texture. */
  private def texel(rgb: Int): Int =
    if ((rgb & 255) == 0) Seen.NoTexel else Seen.texel(Some((rgb >> 16, rgb >> 8 & 255)))

  private def input(view: WorldView): String = {
    import view.{camera, scene}
    val out = new StringBuilder
    def line(values: Any*): Unit = {
      val words = values.map { case d: Double => "%.17g".formatLocal(Locale.ROOT, d); case v => v.toString }
      out ++= words.mkString("", " ", "\n")
    }
    def vector(v: Vec) = Seq(v.x, v.y, v.z)
    val eye = Vec(camera.eye)
    line(view.width, view.height, view.background, flag(view.cullBack), flag(view.depthTest))
    line(flag(camera.orthoHeight.isDefined), camera.orthoHeight.getOrElse(camera.fovDegrees), camera.near, camera.far)
    line(vector(Vec(camera.at) - eye) ++ vector(Vec(camera.up).unit): _*)
    line(view.turnDegrees +: vector(view.middle - eye): _*)
    view.light match {
      case Some(l) => line(1.0 +: vector(Vec(l).unit): _*)
      case None    => line(0, 0, 0, 1)
    }
    val pictures = scene.materials.flatMap(m => m.texture.map(_ -> view.wrapOf(m))).distinct
    line(pictures.length)
    pictures.foreach { case (p, wrap) =>
      line(
        p.width,
        p.height,
        flag(p.hasAlpha),
        wrap match { case Wrap.Repeat => 0; case Wrap.Clamp => 1; case Wrap.Mirror => 2 }
      )
      rowsFromBottom(p).foreach(row => line(row.map(c => c & 0xffffffffL): _*))
    }
    line(view.order.length)
    for (i <- view.order) {
      val t = scene.triangles(i)
      val m = scene.materials(t.material)
      line(
        i + 1,
        textureOf(m).fold(-1)(p => pictures.indexOf(p -> view.wrapOf(m))),
        flag(replaces(m, view)),
        flag(m.blend),
        m.alphaTest.getOrElse(-1.0)
      )
      for (v <- t.vertices)
        line(vector(Vec(v.position) - eye) ++ vector(Vec(v.normal)) ++ Seq(v.s, v.t) ++ color(v, m): _*)
    }
    out.toString
  }

  private def textureOf(m: Material): Option[TextureImage] = m.texture.filter(_ => m.combine != Combine.ColorOnly)

  /** A texture that replaces the colour would hide the light. */
  private def replaces(m: Material, view: WorldView) = m.combine == Combine.Replace && view.light.isEmpty

  private def color(v: MeshVertex, m: Material): Seq[Double] =
    Seq(v.color._1 * m.color._1, v.color._2 * m.color._2, v.color._3 * m.color._3, v.color._4 * m.alpha)

  private def rowsFromBottom(p: TextureImage): Seq[IndexedSeq[Int]] = p.argb.grouped(p.width).toSeq.reverse

  private def flag(b: Boolean) = if (b) 1 else 0
}
