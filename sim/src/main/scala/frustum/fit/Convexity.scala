package frustum.fit

import frustum.driver.linear.Vector3
import frustum.driver.scene.Scene
import frustum.scene.Grid

/** Meshes of which no part can hide another. */
sealed abstract class Convexity
object Convexity {

  /** Flat, seen from both sides. */
  case object Flat extends Convexity

  /** The surface of a convex solid: its front faces hide nothing but its back faces. */
  case object Solid extends Convexity

  private def planes(scene: Scene) =
    scene.triangles.flatMap(t => Grid.faceNormal(t).map(n => n -> n.dot(t.v0.position)))

  /** Whether a point is behind every face: from there a solid is nothing, for its back faces are culled. */
  def inside(scene: Scene, point: Vector3): Boolean = planes(scene).forall { case (n, d) =>
    n.dot(point) < d
  }

  /** What a scene is, None where parts of it may hide others. */
  def of(scene: Scene): Option[Convexity] = {
    val tolerance = 1e-9 * scene.boundingSphere._2
    val points = scene.triangles.flatMap(_.vertices.map(_.position)).distinct
    val faces = planes(scene)
    def beyond(n: Vector3, d: Double) = points.map(p => n.dot(p) - d)
    if (faces.isEmpty || scene.materials.exists(_.blend)) None
    else if (faces.forall { case (n, d) => beyond(n, d).forall(_.abs <= tolerance) }) Some(Flat)
    else if (faces.forall { case (n, d) => beyond(n, d).forall(_ <= tolerance) } && closed(scene))
      Some(Solid)
    else None
  }

  /** Each side of a triangle is a side of one other, the other way. */
  private def closed(scene: Scene): Boolean = {
    val sides = scene.triangles.flatMap { t =>
      val p = t.vertices.map(v => (v.position.x, v.position.y, v.position.z))
      Seq(p(0) -> p(1), p(1) -> p(2), p(2) -> p(0))
    }
    val set = sides.toSet
    set.size == sides.length && sides.forall { case (a, b) => set(b -> a) }
  }
}
