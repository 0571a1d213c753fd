package frustum.ray

import frustum.spec.{RayProgram, RayScene, VideoMode}

/** A ray caster for one scene on one raster. */
case class RayConfig(scene: RayScene, mode: VideoMode) {
  val program: RayProgram = RayProgram(scene, mode.width, mode.height)
}
