package frustum.ray

import frustum.spec.{RayProgram, RayScene, RayShade, VideoMode}

/** A ray caster for one scene on one raster. */
case class RayConfig(scene: RayScene, mode: VideoMode) {
  val program: RayProgram = RayProgram(scene, mode.width, mode.height)

  /** How spheres are shaded, if there are any and a light. */
  lazy val shade: Option[RayShade] = RayShade(scene, program, mode.width, mode.height)
}
