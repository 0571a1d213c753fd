package frustum.contract.ray

import frustum.contract.arithmetic.{IntVector, Interval}

/** A coordinate that moves: `axis` of a point, whose word is at `address`. */
case class RayInput(of: RayMoving, axis: Int, address: Int, range: Interval)

/** Points and vectors of a scene that may move. */
sealed trait RayMoving {
  def in(scene: RayScene): RayBox
  def in(motion: RayMotion, scene: RayScene): IntVector
}

object RayMoving {
  case class Sphere(index: Int) extends RayMoving {
    def in(s: RayScene): RayBox = s.spheres(index).box
    def in(m: RayMotion, s: RayScene): IntVector = m.spheres(index)
    override def toString = s"sphere $index"
  }
  case class Quad(index: Int) extends RayMoving {
    def in(s: RayScene): RayBox = RayBox(s.quads(index).low, s.quads(index).high)
    def in(m: RayMotion, s: RayScene): IntVector = m.quads(index)
    override def toString = s"quad $index"
  }

  /** Vector of the camera: eye, corner, right, down. */
  case class Camera(index: Int) extends RayMoving {
    def in(s: RayScene): RayBox = RayBox(s.camera.low.vectors(index), s.camera.high.vectors(index))
    def in(m: RayMotion, s: RayScene): IntVector = m.cameraOf(s).vectors(index)
    override def toString = s"camera's ${RayCameraRange.Vectors(index)}"
  }
}
