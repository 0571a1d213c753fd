package frustum.referee

import frustum.contract.raster.Wrap
import frustum.driver.linear.Vector3
import frustum.driver.scene.{Camera, Material, Scene}

/** What a user asked for, and all that the referee knows of a picture.
  *
  * @param light       direction towards the light in world space; None: texture and vertex colour alone
  * @param cullBack    only triangles that turn counter-clockwise in the window show
  * @param background  0xRRGGBB
  * @param turnDegrees the model is turned by so much about +y through the middle of its bounding box, counter-clockwise
  *                    as seen from above; neither camera nor light turn with it
  * @param depthTest   false: what is listed last shows
  */
final case class WorldView(
    scene: Scene,
    camera: Camera,
    width: Int,
    height: Int,
    light: Option[Vector3],
    cullBack: Boolean,
    wrap: Wrap,
    background: Int,
    turnDegrees: Double,
    depthTest: Boolean = true
) {

  /** The middle of the box around all vertices. */
  val middle: Vec = {
    val points = scene.triangles.flatMap(_.vertices.map(v => Vec(v.position)))
    def half(of: Vec => Double) = if (points.isEmpty) 0.0 else (points.map(of).min + points.map(of).max) / 2
    Vec(half(_.x), half(_.y), half(_.z))
  }

  /** Indices of the scene's triangles in the order of drawing: what is opaque as it is listed, then what is blended,
    * the farthest centroid along the line of sight first.
    */
  val order: IndexedSeq[Int] = {
    val space = EyeSpace(this)
    val (blended, opaque) = scene.triangles.indices.partition(isBlended)
    def distance(i: Int) = scene.triangles(i).vertices.map(v => space.eye(v.position).z).sum
    opaque ++ blended.sortBy(i => -distance(i))
  }

  /** A material's own way of wrapping goes before the one asked for all. */
  def wrapOf(material: Material): Wrap = material.wrap.getOrElse(wrap)

  def isBlended(triangle: Int): Boolean = scene.materials(scene.triangles(triangle).material).blend
}
