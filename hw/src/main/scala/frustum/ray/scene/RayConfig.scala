package frustum.ray.scene

import frustum.contract.ray.{RayProgram, RayScene, RayShade}
import frustum.contract.video.VideoMode
import frustum.ray.program.RaySetupTiming

/** A ray caster for one scene on one raster.
  *
  * @param fast more registers, for a higher clock frequency where they cost little
  */
case class RayConfig(scene: RayScene, mode: VideoMode, fast: Boolean = false) {
  val program: RayProgram = RayProgram(scene, mode.width, mode.height)

  /** The smallest set-up that is ready in time; if none is, the fastest, which is then refused with its figures. */
  val setup: RaySetupTiming = {
    val all = RaySetupTiming.Digits.map(RaySetupTiming(program, _, fast))
    all.find(t =>
      t.frameClocks <= frameLimit && t.lineClocks + t.rowClocks <= mode.hTotal - RayConfig.Latency
    )
      .getOrElse(all.last)
  }

  /** Clocks from `latch` until the first row's load. */
  def frameLimit: Int = mode.blankClocks - mode.hTotal

  /** Whether a ray of the picture may have no length. */
  lazy val anyRay: Boolean = scene.camera.squares(mode.width, mode.height)._1 == 0

  /** How spheres are shaded, if there are any and a light. */
  lazy val shade: Option[RayShade] = RayShade(scene, program, mode.width, mode.height)
}

object RayConfig {

  /** Clocks that are kept for the pixels' latency. */
  val Latency = 32
}
