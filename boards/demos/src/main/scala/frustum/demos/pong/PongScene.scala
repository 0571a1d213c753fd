package frustum.demos.pong

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{RayCamera, RayCameraRange, RayQuad, RayRoom, RayScene, RaySphere}

/** The room of 3-D pong: puck and paddle, which move within the limits of [[PongRules]], walls and light. */
object PongScene {
  import PongRules._
  val Eye = IntVector(0, 0, -320)
  val Light = IntVector(-120, 200, 160)

  /** @param pixel
    *   units between neighbouring pixels: 1 for 640 x 480, 16 for 40 x 30, which has the same field of view
    */
  def room(width: Int = 640, height: Int = 480, pixel: Int = 1, centred: Boolean = true): RayScene = RayScene(
    RayCameraRange(RayCamera.forward(Eye, width, height, 320, pixel, centred)),
    RayRoom(IntVector(-320, -240, 0), IntVector(320, 240, 640), 6),
    Seq(RaySphere(PuckLow, PuckHigh, PuckRadius, 0xff0000)),
    Seq(RayQuad(IntVector(-PaddleX, -PaddleY, 640), IntVector(PaddleX, PaddleY, 640), Reach, 0xffffff)),
    Some(Light),
    0xffff00
  )
}
