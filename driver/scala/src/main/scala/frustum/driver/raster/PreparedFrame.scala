package frustum.driver.raster

import frustum.contract.raster.{FramePass, RasterConfig, RenderState, TextureUpload, Wrap}
import frustum.driver.linear.{Vector3, Vector4}

/** How a scene is to be drawn.
  *
  * @param light
  *   direction towards the light, world space; None: texture and vertex colour alone
  * @param cullBack
  *   drop triangles that are clockwise on the screen
  * @param wrap
  *   for both texture coordinates, of materials without one of their own
  * @param background
  *   0xRRGGBB
  * @param depthTest
  *   false where nothing drawn hides anything else drawn
  * @param turnDegrees
  *   the model is turned about +y through the centre of its bounding sphere; the light is not
  */
final case class DrawOptions(
    light: Option[Vector3],
    cullBack: Boolean,
    wrap: Wrap,
    background: Int,
    turnDegrees: Double = 0,
    depthTest: Boolean = true
)

/** A vertex in clip space before quantisation: inside when -w <= x, y, z <= w. `rgba` is 0..1, lit. */
final case class ClipVertex(clip: Vector4, s: Double, t: Double, rgba: Vector4)

/** A triangle that survived clipping and culling, in the order of its vertices on the wire.
  *
  * @param source
  *   which triangle of the scene it is, or is a part of
  */
final case class ClipTriangle(v: IndexedSeq[ClipVertex], state: RenderState, source: Int = 0)

/** Triangles, after clipping, that are not sent.
  *
  * @param facingAway
  *   away from the viewer, where such are to be left out
  * @param withoutArea
  *   snapped to the screen
  * @param withoutPixel
  *   whose box holds no centre of a pixel of the screen
  */
final case class LeftOut(facingAway: Int = 0, withoutArea: Int = 0, withoutPixel: Int = 0) {
  def +(o: LeftOut): LeftOut =
    LeftOut(facingAway + o.facingAway, withoutArea + o.withoutArea, withoutPixel + o.withoutPixel)
}

/** A frame ready for any engine.
  *
  * @param textures
  *   to be sent once, before the first pass
  * @param passes
  *   to be sent in order; their regions are disjoint and cover the screen
  * @param clipTriangles
  *   the drawn triangles, unquantised, in drawing order
  * @param sceneTriangles
  *   triangles of the scene, before clipping
  * @param trianglesDrawn
  *   triangles after clipping and culling, each counted once however many passes draw it
  * @param sources
  *   for each triangle of each pass, which of the scene's it is, or is a part of
  * @param leftOut
  *   triangles that are not drawn, by cause
  */
final case class PreparedFrame(
    config: RasterConfig,
    textures: Seq[TextureUpload],
    passes: Seq[FramePass],
    clipTriangles: IndexedSeq[ClipTriangle],
    sceneTriangles: Int,
    trianglesDrawn: Int,
    sources: Seq[IndexedSeq[Int]],
    leftOut: LeftOut = LeftOut()
)
