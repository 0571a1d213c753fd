package frustum.model.raster

import frustum.contract.raster.{RasterConfig, RenderState}

/** A covered pixel's place on the screen and its planes, as in `frustum.raster.scan.InterpolatedFragment`, colours left
  * out.
  */
final case class ScreenFragment(triangle: Int, x: Int, y: Int, s: Int, t: Int, q: Int, z: Int)

/** Hands on what a rasterizer makes of a frame, pixel by pixel. */
final class ScreenFragments(config: RasterConfig)(each: ScreenFragment => Unit) extends FragmentSink {
  private var (left, top) = (0, 0)

  def tile(tileX: Int, tileY: Int): Unit = {
    left = tileX * config.tileWidth; top = tileY * config.tileHeight
  }
  def tileEnd(tileX: Int, tileY: Int): Unit = ()
  def fragment(
      triangle: Int,
      state: RenderState,
      x: Int,
      y: Int,
      s: Int,
      t: Int,
      q: Int,
      z: Int,
      r: Int,
      g: Int,
      b: Int,
      a: Int
  ): Unit = each(ScreenFragment(triangle, left + x, top + y, s, t, q, z))
}
