package frustum.ray.hit

import frustum.arithmetic.LockstepPipeline
import frustum.contract.ray.{RayScene, Wall}
import frustum.ray.walk.RayWalkers
import spinal.core._
import spinal.lib.misc.pipeline._

/** Whether a sphere is between the light and the wall that is hit: `SHADOW`, a node after `start`. */
class ShadowStage(scene: RayScene, walkers: RayWalkers, line: LockstepPipeline, walls: WallStage, start: Int)
    extends Area {
  val SHADOW = Payload(Bool())
  private val CONES = Payload(Bits(Wall.all.size bits))

  /** v.S > 0. Where it is 0 the discriminant is negative, unless the sphere holds the light or the ray ends in it. */
  private def gate(form: String) = if (scene.lightIsFree) !walkers.negative(form) else walkers(form) > 0

  private val cones = for (_ <- scene.light.toSeq; i <- scene.spheres.indices) yield {
    val cone = Wall.all.map(w => gate(s"gate${i}_${w.index}") && !walkers.negative(s"shadow${i}_${w.index}"))
    val enclosed = walkers(s"power$i") <= 0
    Vec(cone).asBits | B(Wall.all.size bits, default -> enclosed)
  }
  line(start)(CONES) := cones.foldLeft(B(0, Wall.all.size bits))(_ | _)
  line(start + 1)(SHADOW) := (line(start + 1)(CONES) & line(start + 1)(walls.WALL)).orR
}
