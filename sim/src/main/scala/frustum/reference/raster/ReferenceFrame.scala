package frustum.reference.raster

import frustum.contract.raster.{RasterConfig, RenderState}

/** A frame being drawn in double precision; arrays are row by row from the top left.
  *
  * `winner` is the triangle that last gave a pixel its colour, `nearest` the one that last wrote its depth,
  * numbered as drawn over all passes; -1 where there is none. `depth` starts at the farthest value.
  */
final class ReferenceFrame(val config: RasterConfig) {
  private val pixels = config.width * config.height
  val color: Array[Rgba] = Array.fill(pixels)(Rgba(0, 0, 0, 255))
  val depth: Array[Double] = Array.fill(pixels)(ScreenVertex.DepthMax)
  val winner: Array[Int] = Array.fill(pixels)(-1)
  val nearest: Array[Int] = Array.fill(pixels)(-1)

  def clear(rect: PixelRect, to: Rgba): Unit =
    for (y <- rect.y0 to rect.y1; x <- rect.x0 to rect.x1) {
      val i = y * config.width + x
      color(i) = to; depth(i) = ScreenVertex.DepthMax; winner(i) = -1; nearest(i) = -1
    }

  /** Alpha test, depth test, blend and write of one fragment; true if it passed the tests. */
  def write(triangle: Int, x: Int, y: Int, z: Double, source: Rgba, state: RenderState): Boolean = {
    val i = y * config.width + x
    val passes =
      if (z < depth(i)) state.depth.less else if (z == depth(i)) state.depth.equal else state.depth.greater
    val drawn = Shading.passesAlphaTest(state, source.a) && passes
    if (drawn) {
      if (state.depthWrite) { depth(i) = z; nearest(i) = triangle }
      winner(i) = triangle
      color(i) = if (state.blend) blend(source, color(i)) else source
    }
    drawn
  }

  /** source * alpha + destination * (1 - alpha). */
  private def blend(s: Rgba, d: Rgba): Rgba = {
    val k = s.a / 255
    Rgba(s.r * k + d.r * (1 - k), s.g * k + d.g * (1 - k), s.b * k + d.b * (1 - k), 255)
  }

  /** 0xRRGGBB, each component rounded to nearest: the only rounding. */
  def rgb888: Array[Int] = color.map(c => c.r.round.toInt << 16 | c.g.round.toInt << 8 | c.b.round.toInt)

  /** RGB565 of the same colours, each component rounded to nearest. */
  def rgb565: Array[Int] = color.map { c =>
    def level(v: Double, most: Int) = (v / 255 * most).round.toInt
    level(c.r, 31) << 11 | level(c.g, 63) << 5 | level(c.b, 31)
  }
}
