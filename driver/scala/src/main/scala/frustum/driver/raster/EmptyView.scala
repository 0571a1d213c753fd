package frustum.driver.raster

import frustum.contract.raster.RasterConfig
import frustum.driver.linear.{Matrix4, Vector4}
import frustum.driver.scene.{Camera, Scene}
import scala.util.Try

/** Whether a picture is empty, and why. */
object EmptyView {

  /** No triangle covers the centre of a pixel. */
  def apply(frame: PreparedFrame): Boolean = {
    val screen = PixelBox(0, 0, frame.config.width - 1, frame.config.height - 1)
    !frame.passes.exists(p =>
      p.triangles.exists(t => PixelCover.covers(Seq(t.v0, t.v1, t.v2).map(p.vertices), screen))
    )
  }

  /** How many triangles in view are not drawn, by cause, if there are any. */
  def leftOut(frame: PreparedFrame): Option[String] = {
    import frame.leftOut._
    Option.when(frame.leftOut != LeftOut())(
      s"of the triangles in view $facingAway face away, $withoutArea have no area, $withoutPixel hold no centre of a " +
        "pixel"
    )
  }

  /** What takes all of a scene out of the picture, and what would help. */
  def cause(scene: Scene, camera: Camera, options: DrawOptions, config: RasterConfig): String = {
    val turn = Driver.turnOf(scene, options)
    val toClip = Projection(camera, config.width.toDouble / config.height) * turn
    val clip = scene.triangles.map(_.vertices.map(v => toClip * Vector4.point(v.position)))
    def outside(plane: Vector4 => Double) = (t: Seq[Vector4]) => t.forall(plane(_) < 0)
    val near = outside(v => v.w + v.z)
    val far = outside(v => v.w - v.z)
    val sides = Seq[Vector4 => Double](v => v.w - v.x, v => v.w + v.x, v => v.w - v.y, v => v.w + v.y).map(outside)
    def emptyUnculled =
      Try(apply(Driver.prepare(scene, camera, options.copy(cullBack = false), config, 0))).getOrElse(false)
    if (clip.forall(far))
      s"the far plane at ${camera.far} cuts everything away; ${reach(scene, camera, turn)}: give a greater --far"
    else if (clip.forall(near))
      s"everything lies before the near plane at ${camera.near} or behind the eye; ${reach(scene, camera, turn)}: " +
        "turn the camera by --at or give a smaller --near"
    else if (clip.forall(t => (near +: far +: sides).exists(_(t))))
      "everything lies outside of the picture: turn the camera towards it by --at or move it by --eye"
    else if (options.cullBack && !emptyUnculled)
      "every triangle in the picture shows its back, which --cull back leaves out: leave --cull back out"
    else "no triangle covers the centre of a pixel: come closer or draw a larger picture"
  }

  /** From where to where the scene lies along the line of sight. */
  private def reach(scene: Scene, camera: Camera, turn: Matrix4): String = {
    val sight = (camera.at - camera.eye).normalized
    val depth = scene.triangles.flatMap(_.vertices).map(v =>
      (turn.point(v.position) - camera.eye).dot(sight)
    )
    f"it lies ${depth.min}%.4g to ${depth.max}%.4g from the eye"
  }
}
