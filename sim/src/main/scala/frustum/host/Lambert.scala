package frustum.host

import org.joml.Vector3d

/** Light by Lambert's cosine law, one light infinitely far away: factor = ambient + (1 - ambient) max(0, n . l). */
object Lambert {
  val Ambient = 0.2

  /** @param normal unit length; `towardsLight` of any length; the result lies in Ambient..1 */
  def factor(normal: Vector3d, towardsLight: Vector3d): Double = {
    val cosine = normal.dot(towardsLight) / towardsLight.length
    Ambient + (1 - Ambient) * cosine.max(0.0).min(1.0)
  }
}
