package frustum.driver.raster

import frustum.contract.InputError
import frustum.driver.linear.Vector3

/** Light by Lambert's cosine law, one light infinitely far away: factor = ambient + (1 - ambient) max(0, n .
  * l).
  */
object Lambert {
  val Ambient = 0.2

  /** InputError for a light that has no direction. */
  def check(light: Vector3): Unit =
    if (!light.isFinite || light.length == 0)
      throw InputError(s"light ${light.x},${light.y},${light.z} has no direction; give x,y,z towards it")

  /** @param normal unit length; `towardsLight` of any length; the result lies in Ambient..1 */
  def factor(normal: Vector3, towardsLight: Vector3): Double = {
    val cosine = normal.dot(towardsLight) / towardsLight.length
    Ambient + (1 - Ambient) * cosine.max(0.0).min(1.0)
  }
}
