package frustum.driver.scene

import frustum.driver.linear.Vector3
import java.nio.file.Path

/** A corner of a triangle. Vertices are values: equal ones are shared when the scene is packed for the
  * hardware.
  *
  * @param position
  *   world space, right-handed, y up
  * @param normal
  *   unit length, outwards
  * @param s,t
  *   texture coordinates in repeats, origin at the texture's bottom left
  * @param color
  *   red, green, blue, alpha, 0..1
  */
final case class MeshVertex(
    position: Vector3,
    normal: Vector3,
    s: Double,
    t: Double,
    color: (Double, Double, Double, Double)
)

/** A triangle, counter-clockwise when seen from its front; `material` indexes [[Scene.materials]]. */
final case class Triangle(v0: MeshVertex, v1: MeshVertex, v2: MeshVertex, material: Int) {
  def vertices: Seq[MeshVertex] = Seq(v0, v1, v2)
}

/** Something to draw, and where it is best seen from.
  *
  * @param background
  *   0xRRGGBB
  * @param origin
  *   where it was read from, for messages
  * @param notices
  *   what of its files was skipped or replaced
  */
final case class Scene(
    name: String,
    triangles: IndexedSeq[Triangle],
    materials: IndexedSeq[Material],
    camera: Camera,
    background: Int,
    origin: Option[SceneOrigin] = None,
    notices: IndexedSeq[Notice] = IndexedSeq.empty
) {

  /** What messages call it, and one of its triangles. */
  def place: String = origin.fold(name)(_.file.toString)
  def place(triangle: Int): String =
    origin.fold(s"$name: triangle ${triangle + 1}")(o => s"${o.file}:${o.lines(triangle)}")

  /** Centre and radius of the sphere around the bounding box: radius is that of the farthest vertex from the
    * centre.
    */
  lazy val boundingSphere: (Vector3, Double) = BoundingSphere(triangles.flatMap(_.vertices.map(_.position)))
}

/** The file of a scene, and the line of each triangle. */
final case class SceneOrigin(file: Path, lines: IndexedSeq[Int])

/** The sphere about the middle of the points' bounding box that just holds all of them. */
object BoundingSphere {
  def apply(points: Iterable[Vector3]): (Vector3, Double) = {
    if (points.isEmpty) return (Vector3.Zero, 0.0)
    val centre = (points.reduce(_ min _) + points.reduce(_ max _)) * 0.5
    (centre, points.iterator.map(_.distance(centre)).max)
  }
}
