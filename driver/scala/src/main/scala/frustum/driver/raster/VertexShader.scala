package frustum.driver.raster

import frustum.driver.linear.{Matrix4, Vector3, Vector4}
import frustum.driver.scene.{Material, MeshVertex}

/** Transforms and lights one vertex.
  *
  * @param toClip
  *   model to clip space
  * @param turn
  *   model to world space, a rotation; normals turn with it
  * @param light
  *   direction towards the light, world space
  */
final class VertexShader(toClip: Matrix4, turn: Matrix4, light: Option[Vector3]) {
  def apply(v: MeshVertex, material: Material): ClipVertex = {
    val (r, g, b, a) = v.color
    val bright = light.fold(1.0)(Lambert.factor(turn.direction(v.normal), _))
    ClipVertex(
      toClip * Vector4.point(v.position),
      v.s,
      v.t,
      Vector4(
        r * material.color._1 * bright,
        g * material.color._2 * bright,
        b * material.color._3 * bright,
        a * material.alpha
      )
    )
  }
}
