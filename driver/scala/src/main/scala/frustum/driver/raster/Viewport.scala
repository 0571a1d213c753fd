package frustum.driver.raster

import frustum.contract.raster.{PackedVertex, RasterConfig, VertexRanges}
import frustum.driver.linear.Vector4
import scala.math.round

/** Clip space to the fixed point of [[frustum.contract.raster.PackedVertex]]: y down, 1/16 pixel, depth 0 near to 65535
  * far, everything rounded to nearest.
  */
final class Viewport(config: RasterConfig) {
  def ranges: VertexRanges = config.ranges

  /** Texture coordinates less `offset` whole repeats. w must lie in the declared domain. */
  def pack(v: ClipVertex, offset: (Int, Int)): PackedVertex = {
    val (mantissa, exponent) = PackedVertex.reciprocalW(v.clip.w)
    PackedVertex(
      x = round((v.clip.x / v.clip.w + 1) * config.width * 8).toInt,
      y = round((1 - v.clip.y / v.clip.w) * config.height * 8).toInt,
      z = round((v.clip.z / v.clip.w + 1) * 32767.5).toInt.max(0).min(65535),
      qMantissa = mantissa,
      qExponent = exponent,
      s = round((v.s - offset._1) * 65536).toInt,
      t = round((v.t - offset._2) * 65536).toInt,
      r = Viewport.byte(v.rgba.x),
      g = Viewport.byte(v.rgba.y),
      b = Viewport.byte(v.rgba.z),
      a = Viewport.byte(v.rgba.w)
    )
  }

  /** Twice the area of a triangle in 1/256 square pixels, exact; positive when it turns clockwise on the
    * screen.
    */
  def area(a: PackedVertex, b: PackedVertex, c: PackedVertex): Long =
    (b.x - a.x).toLong * (c.y - a.y) - (b.y - a.y).toLong * (c.x - a.x)

  /** Columns and rows of the screen's pixels whose centres lie in the triangle's bounding box; None if there
    * are none: then nothing can be drawn.
    */
  def pixels(vertices: Seq[PackedVertex]): Option[PixelBox] = {
    def range(low: Int, high: Int, size: Int) = ((low + 7) >> 4).max(0) -> ((high - 8) >> 4).min(size - 1)
    val (x0, x1) = range(vertices.map(_.x).min, vertices.map(_.x).max, config.width)
    val (y0, y1) = range(vertices.map(_.y).min, vertices.map(_.y).max, config.height)
    Option.when(x0 <= x1 && y0 <= y1)(PixelBox(x0, y0, x1, y1))
  }
}

/** A rectangle of pixels, both ends inclusive. */
final case class PixelBox(x0: Int, y0: Int, x1: Int, y1: Int)

object Viewport {

  /** 0..1 to 0..255, rounded to nearest; what lies outside is clamped. */
  def byte(v: Double): Int = round(v * 255).toInt.max(0).min(255)
}
