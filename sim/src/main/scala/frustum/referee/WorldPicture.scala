package frustum.referee

/** A picture drawn in float64 from the world, and what may be judged by it.
  *
  * A pixel is `judged` when its centre lies farther than [[WorldPicture.EdgeMargin]] from every edge that is in view
  * there, and, where a texture decides by its alpha what shows, farther than [[WorldPicture.TexelMargin]] from its
  * texels' borders. Its texels are judged when the textures in view keep that distance as well.
  */
final class WorldPicture(val view: WorldView) {
  import WorldPicture._
  private val space = EyeSpace(view)
  private val count = view.width * view.height
  val surfaces: IndexedSeq[Surface] = view.scene.triangles.indices.map(new Surface(view, space, _))
  private val drawn = view.order.map(surfaces).filter(_.shows)
  val seen = new Seen(count)
  val judged, texelsJudged: Array[Boolean] = Array.fill(count)(true)
  private val depth = Array.fill(count)(1.0)
  private val color, flat = Array.fill(count)(Color.ofWord(view.background | 0xff000000))
  private val flatKnown = Array.fill(count)(true)
  private val layers = new Array[Int](count)

  def x(at: Int): Double = at % view.width + 0.5
  def y(at: Int): Double = view.height - at / view.width - 0.5

  drawn.foreach(draw)
  drawn.foreach(markEdges)

  private def draw(s: Surface): Unit = s.pixels(0) { (i, j) =>
    val at = j * view.width + i
    if (s.window.covers(x(at), y(at)) && (!view.depthTest || s.window.depth(x(at), y(at)) < depth(at))) {
      val place = s.texels(x(at), y(at))
      val texel = place.map { case (u, v) => s.texel(u, v) }
      val shaded = s.shaded(s.vertexColor(x(at), y(at)), texel)
      val onBorder = place.exists { case (u, v) => near(u) || near(v) }
      if (s.alphaTest.isDefined && onBorder) judged(at) = false
      if (s.passesAlphaTest(shaded)) {
        if (!s.isBlended) {
          depth(at) = s.window.depth(x(at), y(at)); layers(at) = 0; texelsJudged(at) = true; flatKnown(at) = true
        }
        if (onBorder) texelsJudged(at) = false
        seen.write(at, s.index, Seen.texel(texel), s.isBlended)
        val quick = s.flatColor(x(at), y(at)).map(s.shaded(_, texel))
        flatKnown(at) &= quick.isDefined
        layers(at) += 1
        color(at) = if (s.isBlended) shaded.over(color(at)) else shaded
        flat(at) = quick.fold(flat(at))(q => if (s.isBlended) q.over(flat(at)) else q)
      }
    }
  }

  private def near(u: Double) = (u - scala.math.rint(u)).abs < TexelMargin

  private def markEdges(s: Surface): Unit = s.pixels(EdgeMargin) { (i, j) =>
    val at = j * view.width + i
    if (judged(at) && s.window.inside(x(at), y(at)).abs <= EdgeMargin && !hidden(s, at, EdgeMargin)) judged(at) = false
  }

  /** Whether all of a triangle's plane within `reach` pixels of a pixel lies behind the opaque surface there. */
  private def hidden(s: Surface, at: Int, reach: Double): Boolean = view.depthTest && {
    val front = seen.opaque(at)
    front >= 0 && depthAt(s, at) - depthAt(surfaces(front), at) > depthTolerance(s, front, reach)
  }

  private def depthAt(s: Surface, at: Int) = s.window.depth(x(at), y(at))

  private def depthTolerance(s: Surface, front: Int, reach: Double) = {
    def slope(l: Line) = l.a.abs + l.b.abs
    reach * (slope(s.window.depth) + slope(surfaces(front).window.depth)) + DepthSteps / 65535
  }

  /** Whether quantisation accounts for a pixel that shows triangle `other` in place of `mine`: vertices on 1/16 pixel
    * move what is seen by [[Snap]] along each axis at most, depths of 16 bits tell no closer ones apart, and texels
    * that are kept or dropped by their alpha move with the vertices.
    */
  def explains(at: Int, mine: Int, other: Int): Boolean = {
    def mayVanish(i: Int) = i >= 0 && surfaces(i).alphaTest.isDefined && borderWithin(surfaces(i), at)
    mine == other || mayVanish(mine) || mayVanish(other) || (mine >= 0 && other >= 0 && {
      val o = surfaces(other)
      o.shows && o.window.inside(x(at), y(at)) > -EdgeMargin && view.depthTest &&
      (depthAt(o, at) - depthAt(surfaces(mine), at)).abs <= depthTolerance(o, mine, Snap)
    })
  }

  /** Whether quantisation accounts for another texel of a triangle at a pixel: one that is seen within [[Snap]] of its
    * centre, coordinates being off by as much as 16 bits of 1/w allow.
    */
  def explainsTexel(at: Int, triangle: Int, texel: Int): Boolean = {
    val s = surfaces(triangle)
    s.texture.fold(texel == Seen.NoTexel) { t =>
      def seenAlong(of: ((Double, Double)) => Double, size: Int, index: Int) = {
        val reached = corners(at, s).map(of)
        val margin = TexelMargin + s.extent.map(of).get / 65536
        val (least, most) = (reached.min - margin, reached.max + margin)
        most - least >= 2 * size || (scala.math.floor(least).toLong to scala.math.floor(most).toLong)
          .exists(Texturing.wrapped(_, size, s.wrap) == index)
      }
      texel >= 0 && seenAlong(_._1, t.width, texel & 0xffff) && seenAlong(_._2, t.height, texel >> 16)
    }
  }

  private def borderWithin(s: Surface, at: Int): Boolean = {
    val reached = corners(at, s)
    def crosses(values: Seq[Double]) =
      scala.math.floor(values.min - TexelMargin) != scala.math.floor(values.max + TexelMargin)
    crosses(reached.map(_._1)) || crosses(reached.map(_._2))
  }

  private def corners(at: Int, s: Surface) =
    for (dx <- Seq(-Snap, Snap); dy <- Seq(-Snap, Snap); t <- s.texels(x(at) + dx, y(at) + dy)) yield t

  /** 0xRRGGBB. */
  lazy val picture: Array[Int] = color.map(_.word)

  /** Whether a colour is that of the pixel's layers: between those of the two ways to interpolate, give or take
    * [[ColorTolerance]] and a step of five bits for each layer more. None where only one way is known.
    */
  def sameColor(at: Int, rgb: Int): Option[Boolean] = Option.when(flatKnown(at)) {
    val tolerance = ColorTolerance + ColorStep * (layers(at) - 1).max(0)
    Color.ofWord(rgb).rgb.zip(color(at).rgb.zip(flat(at).rgb)).forall { case (c, (a, b)) =>
      c >= a.min(b) - tolerance && c <= a.max(b) + tolerance
    }
  }
}

object WorldPicture {

  /** Pixels from an edge, and texels from a texel's border, that are not judged. */
  val EdgeMargin: Double = 1.0 / 8
  val TexelMargin: Double = 1.0 / 64

  /** Snapping to 1/16 pixel moves a vertex by 1/32 along each axis at most, and what is seen by no more than the
    * vertices.
    */
  val Snap: Double = 1.0 / 32

  /** Steps of 1/65535 by which depths of 16 bits may be off. */
  val DepthSteps: Double = 4

  /** A step of five bits a channel is 8.2; a texel of four bits is off by half of 17, the pixel by half a step. */
  val ColorStep: Double = 255.0 / 31
  val ColorTolerance: Double = 16
}
