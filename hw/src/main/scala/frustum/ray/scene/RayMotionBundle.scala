package frustum.ray.scene

import frustum.contract.ray.{RayCameraRange, RayInput, RayMoving, RayScene}
import spinal.core._

/** Positions, in units; constant coordinates of the scene are ignored. The camera is present if it moves. */
case class RayMotionBundle(scene: RayScene) extends Bundle {
  val spheres = Vec.fill(scene.spheres.size)(RayPoint())
  val quads = Vec.fill(scene.quads.size)(RayPoint())
  val camera =
    !scene.camera.fixed generate Vec.fill(RayCameraRange.Vectors.size)(RayPoint()) // in the order of `Vectors`

  private def point(of: RayMoving): RayPoint = of match {
    case RayMoving.Sphere(n) => spheres(n)
    case RayMoving.Quad(n)   => quads(n)
    case RayMoving.Camera(n) => camera(n)
  }

  def apply(i: RayInput): SInt = {
    require(
      i.range.width <= RayPoint.Bits,
      s"${i.of} goes from ${i.range.low} to ${i.range.high} along axis ${i.axis}, which needs ${i.range.width} bits, " +
        s"at most ${RayPoint.Bits}"
    )
    point(i.of)(i.axis).resize(i.range.width)
  }
}

case class RayPoint() extends Bundle {
  val x, y, z = SInt(RayPoint.Bits bits)
  def apply(axis: Int): SInt = Seq(x, y, z)(axis)
}

object RayPoint {
  val Bits = 12
}
