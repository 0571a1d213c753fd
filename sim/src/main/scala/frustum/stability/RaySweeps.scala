package frustum.stability

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{RayDomains, RayMotion, RaySphere}
import frustum.demos.pong.PongScene
import frustum.judge.RayJudge
import frustum.model.ray.RayPicture

/** Spheres in the room of pong, the model held against exact arithmetic. */
object RaySweeps {

  /** Over a screen that many pixels wide; greatest colour error, 255 when a silhouette, a shadow, a checker cell or an
    * object is wrong anywhere.
    */
  private def error(width: Int, centre: IntVector, radius: Int, light: IntVector): Double = {
    val height = width * 3 / 4
    val scene = PongScene.room(width, height, 640 / width).copy(
      spheres = Seq(RaySphere(centre, centre, radius, 0xff0000)),
      light = Some(light)
    )
    val motion = RayMotion(Seq(centre), Seq(IntVector(0, 0, 640)))
    val pixels = new RayPicture(scene, width, height)(motion)
    val counts = new RayJudge(scene, width, height)(motion, pixels.map(_.objectId), pixels.map(_.rgb))
    val wrong =
      counts.silhouettePixelsWrong + counts.shadowPixelsWrong + counts.objectPixelsWrong + counts.checkerCellsWrong
    if (wrong > 0) 255 else counts.maxColourError
  }

  private val middle = IntVector(0, 0, 320)

  val all: Seq[Sweep] = Seq(
    Sweep(RayDomains.SphereDistance, 1, 1024, 16, whole = true)(d =>
      error(80, IntVector(0, 0, PongScene.Eye.z + d.toInt), 20, PongScene.Light)
    ),
    Sweep(RayDomains.SphereRadius, 1, 400, 16, whole = true)(r =>
      error(80, middle, r.toInt, IntVector(-300, 230, 20))
    ),
    Sweep(RayDomains.LightDistance, 0, 300, 16, whole = true)(d =>
      error(
        640,
        IntVector(PongScene.Light.x, PongScene.Light.y, PongScene.Light.z + 20 + d.toInt),
        20,
        PongScene.Light
      )
    )
  )
}
