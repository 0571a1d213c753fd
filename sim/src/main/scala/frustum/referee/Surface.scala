package frustum.referee

import frustum.contract.raster.{Combine, Wrap}
import frustum.driver.scene.{MeshVertex, TextureImage}
import scala.math.floor

/** A triangle of the scene as it stands in the window, with what its material says.
  *
  * Light is that of OpenGL's fixed function (OpenGL 2.1, 2.14.1): a directional light of diffuse 0.8, an ambient of
  * 0.2, the vertex's colour as both materials: c (0.2 + 0.8 max(0, n . l)), per vertex. Texture environment:
  * GL_MODULATE, or GL_REPLACE where there is no light for a texture to hide (table 3.21); without alpha in the texture
  * the fragment keeps the vertex's.
  */
final class Surface(view: WorldView, space: EyeSpace, val index: Int) {
  private val triangle = view.scene.triangles(index)
  private val vertices = triangle.vertices.toIndexedSeq
  private val material = view.scene.materials(triangle.material)
  val window = new WindowTriangle(vertices.map(v => space.window(v.position)))

  val isBlended: Boolean = material.blend
  val alphaTest: Option[Double] = material.alphaTest
  val texture: Option[TextureImage] = material.texture.filter(_ => material.combine != Combine.ColorOnly)
  val wrap: Wrap = view.wrapOf(material)
  private val replaces = material.combine == Combine.Replace && view.light.isEmpty

  /** Whether anything of it is to be drawn. */
  val shows: Boolean = !window.isDegenerate && (window.isFront || !view.cullBack)

  private def lit(v: MeshVertex): Color = {
    val bright = view.light.fold(1.0) { l =>
      0.2 + 0.8 * (space.turned(Vec(v.normal)) dot Vec(l).unit).max(0.0).min(1.0)
    }
    val (vertex, own) = (v.color, material.color)
    def channel(c: Double, m: Double) = 255 * (c * m * bright).max(0).min(1)
    Color(
      channel(vertex._1, own._1),
      channel(vertex._2, own._2),
      channel(vertex._3, own._3),
      vertex._4 * material.alpha
    )
  }
  private val colors = vertices.map(lit)

  private def blended(weights: IndexedSeq[Double]): Color = {
    def channel(f: Color => Double) = (0 to 2).map(i => weights(i) * f(colors(i))).sum
    Color(channel(_.r), channel(_.g), channel(_.b), channel(_.a))
  }

  /** Vertex colour at a point, perspective-correct as OpenGL 2.1, 3.5.1, has it. */
  def vertexColor(x: Double, y: Double): Color = blended(window.weights(x, y))

  /** Vertex colour linear in the window, which OpenGL allows as the faster way (5.6, GL_PERSPECTIVE_CORRECTION_HINT)
    * and the hardware takes. Where the triangle is cut by near or far, None unless its colour is one all over.
    */
  def flatColor(x: Double, y: Double): Option[Color] =
    if (colors.distinct.length == 1) Some(colors.head)
    else Option.when(window.isWhole)(window.windowWeights(x, y)).flatten.map(blended)

  /** Texture coordinates in texels at a point; None without a texture. */
  def texels(x: Double, y: Double): Option[(Double, Double)] = texture.map { t =>
    val weights = window.weights(x, y)
    def along(f: MeshVertex => Double) = (0 to 2).map(i => weights(i) * f(vertices(i))).sum
    (along(_.s) * t.width, along(_.t) * t.height)
  }

  /** Texels from the least to the greatest coordinate, along s and t. */
  lazy val extent: Option[(Double, Double)] = texture.map { t =>
    def span(values: Seq[Double]) = values.max - values.min
    (span(vertices.map(_.s)) * t.width, span(vertices.map(_.t)) * t.height)
  }

  /** Texel (i, j) that coordinates in texels mean. */
  def texel(u: Double, v: Double): (Int, Int) = {
    val t = texture.get
    (
      Texturing.wrapped(floor(u).toLong, t.width, wrap),
      Texturing.wrapped(floor(v).toLong, t.height, wrap)
    )
  }

  /** The fragment's colour from the vertices' and the texel. */
  def shaded(vertex: Color, at: Option[(Int, Int)]): Color = at.fold(vertex) { case (i, j) =>
    val picture = texture.get
    val c = Texturing.texel(picture, i, j)
    val alpha = if (!picture.hasAlpha) vertex.a else if (replaces) c.a else c.a * vertex.a
    if (replaces) c.copy(a = alpha)
    else Color(c.r * vertex.r / 255, c.g * vertex.g / 255, c.b * vertex.b / 255, alpha)
  }

  def passesAlphaTest(color: Color): Boolean = alphaTest.forall(color.a >= _)

  /** Visits the pixels of the window, rows from the top, whose centres may lie within `margin` of the triangle. */
  def pixels(margin: Double)(visit: (Int, Int) => Unit): Unit = {
    val (left, right, bottom, top) = window.box
    def column(x: Double) = x.max(-2.0).min(view.width + 2.0)
    def row(y: Double) = y.max(-2.0).min(view.height + 2.0)
    val (i0, i1) = (floor(column(left - margin)).toInt.max(0), floor(column(right + margin)).toInt.min(view.width - 1))
    val (j0, j1) = (
      (view.height - 1 - floor(row(top + margin)).toInt).max(0),
      (view.height - 1 - floor(row(bottom - margin)).toInt).min(view.height - 1)
    )
    for (j <- j0 to j1; i <- i0 to i1) visit(i, j)
  }
}
