package frustum.reference.raster

import frustum.contract.raster.{PackedVertex, RasterConfig}
import frustum.driver.raster.ClipVertex

/** A vertex on the screen in double precision.
  *
  * @param x,y     pixels from the screen's top left corner, y down; pixel (i, j) has its centre at (i + 0.5,
  *                j + 0.5)
  * @param z       window depth, 0 (near) to 65535 (far)
  * @param q       1/w
  * @param s,t     texture coordinates in repeats, not divided by w
  * @param r,g,b,a 0..255
  */
final case class ScreenVertex(
    x: Double,
    y: Double,
    z: Double,
    q: Double,
    s: Double,
    t: Double,
    r: Double,
    g: Double,
    b: Double,
    a: Double
)

object ScreenVertex {
  val DepthMax = 65535.0

  /** Exactly the values that the hardware's vertex stands for. */
  def of(v: PackedVertex): ScreenVertex = ScreenVertex(
    v.x / 16.0,
    v.y / 16.0,
    v.z,
    scala.math.scalb(v.qMantissa.toDouble, v.qExponent - 31),
    v.s / 65536.0,
    v.t / 65536.0,
    v.r,
    v.g,
    v.b,
    v.a
  )

  /** Perspective division and OpenGL's viewport transform (OpenGL 2.1, 2.11.1) with the y axis turned down;
    * the depth range 0..1 is scaled to [[DepthMax]]. Nothing is rounded.
    */
  def of(v: ClipVertex, config: RasterConfig): ScreenVertex = {
    val c = v.clip
    ScreenVertex(
      (c.x / c.w + 1) / 2 * config.width,
      (1 - c.y / c.w) / 2 * config.height,
      (c.z / c.w + 1) / 2 * DepthMax,
      1 / c.w,
      v.s,
      v.t,
      v.rgba.x * 255,
      v.rgba.y * 255,
      v.rgba.z * 255,
      v.rgba.w * 255
    )
  }
}
