package frustum.driver.raster

import frustum.driver.scene.{Material, MeshVertex}
import org.joml.{Matrix4d, Vector3d, Vector4d}

/** Transforms and lights one vertex.
  *
  * @param toClip
  *   model to clip space
  * @param turn
  *   model to world space, a rotation; normals turn with it
  * @param light
  *   direction towards the light, world space
  */
final class VertexShader(toClip: Matrix4d, turn: Matrix4d, light: Option[Vector3d]) {
  def apply(v: MeshVertex, material: Material): ClipVertex = {
    val (r, g, b, a) = v.color
    val bright = light.fold(1.0)(Lambert.factor(turn.transformDirection(new Vector3d(v.normal)), _))
    ClipVertex(
      toClip.transform(new Vector4d(v.position, 1)),
      v.s,
      v.t,
      new Vector4d(
        r * material.color._1 * bright,
        g * material.color._2 * bright,
        b * material.color._3 * bright,
        a * material.alpha
      )
    )
  }
}
