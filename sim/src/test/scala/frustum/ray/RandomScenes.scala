package frustum.ray

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{
  RayCamera,
  RayCameraRange,
  RayChecker,
  RayImage,
  RayMotion,
  RayPaint,
  RayScene,
  RaySolid,
  RaySphere,
  Wall
}
import frustum.demos.pong.PongScene
import scala.util.Random

/** Scenes and motions drawn from a seed. */
object RandomScenes {
  private def between(r: Random, low: Int, high: Int): Int = low + r.nextInt(high - low + 1)
  private def within(r: Random, low: IntVector, high: IntVector): IntVector =
    IntVector(between(r, low.x, high.x), between(r, low.y, high.y), between(r, low.z, high.z))

  def motion(scene: RayScene, r: Random): RayMotion =
    RayMotion(
      scene.spheres.map(s => within(r, s.low, s.high)),
      scene.quads.map(q => within(r, q.low, q.high))
    )

  /** Pong with a camera that goes where it likes before the room or, its puck staying at the back, in it, and turns as
    * it likes.
    */
  def moving(width: Int, height: Int, pixel: Int, inside: Boolean): RayScene = {
    val pong = PongScene.room(width, height, pixel)
    def all(n: Int) = (IntVector(-n, -n, -n), IntVector(n, n, n))
    val (eye, far) =
      if (inside) (IntVector(-100, -100, 50), IntVector(100, 100, 300))
      else (IntVector(-100, -100, -320), IntVector(100, 100, -100))
    val (low, high) = all(2 * pixel)
    val long =
      scala.math.ceil(1.05 * scala.math.sqrt(pong.camera.squares(width + 1, height + 1)._2.toDouble)).toInt
    val (near, wide) = all(long)
    val puck = pong.spheres.head
    pong.copy(
      camera =
        RayCameraRange(RayCamera(eye, near, low, low), RayCamera(far, wide, high, high), Some((550, long))),
      spheres = Seq(if (inside) puck.copy(low = puck.low.copy(z = 400)) else puck)
    )
  }

  /** A camera that `moving` accepts, by yaw, pitch and roll, its vectors rounded. */
  def camera(scene: RayScene, r: Random, width: Int, height: Int, pixel: Int): RayCamera = {
    val eye = within(r, scene.eye.low, scene.eye.high)
    val angles = Seq.fill(3)(r.nextDouble() * 2 * scala.math.Pi)
    def turn(v: Seq[Double]) =
      angles.zip(Seq((0, 2), (1, 2), (0, 1))).foldLeft(v) { case (u, (angle, (i, j))) =>
        val (c, s) = (scala.math.cos(angle), scala.math.sin(angle))
        u.updated(i, c * u(i) - s * u(j)).updated(j, s * u(i) + c * u(j))
      }
    def vector(x: Int, y: Int, z: Int) = {
      val Seq(a, b, c) = turn(Seq(x.toDouble, y.toDouble, z.toDouble)).map(scala.math.round(_).toInt)
      IntVector(a, b, c)
    }
    RayCamera(
      eye,
      vector((1 - width) * pixel, (height - 1) * pixel, 640),
      vector(2 * pixel, 0, 0),
      vector(0, -2 * pixel, 0)
    )
  }

  /** One of each kind, images of random sizes and colours. */
  def paint(r: Random, wall: Boolean): RayPaint = r.nextInt(if (wall) 3 else 2) match {
    case 0 => RaySolid(r.nextInt(1 << 24))
    case 1 =>
      val (width, height) = (1 << r.nextInt(6), 1 << r.nextInt(6))
      RayImage(width, height, r.nextInt(7), IndexedSeq.fill(width * height)(r.nextInt(1 << 24)))
    case _ => RayChecker(3 + r.nextInt(5))
  }
  def painted(scene: RayScene, r: Random): RayScene = scene.copy(
    room = scene.room.copy(paints = Wall.all.map(_ => paint(r, wall = true))),
    quads = scene.quads.map(_.copy(paint = paint(r, wall = false)))
  )

  /** Room of pong, other eye, orientation, light and up to 8 spheres that stand apart: near the eye, behind it,
    * touching walls.
    */
  def scene(r: Random, width: Int, height: Int): RayScene = {
    val room = PongScene.room().room
    val eye = IntVector(between(r, -200, 200), between(r, -200, 200), between(r, -320, 300))
    def axis(n: Int) = IntVector(between(r, -n, n), between(r, -n, n), between(r, -n, n))
    val camera = RayCamera(
      eye,
      IntVector(between(r, -600, 600), between(r, -600, 600), between(r, -200, 600)),
      axis(32),
      axis(32)
    )
    val light = IntVector(between(r, -300, 300), between(r, -220, 220), between(r, 0, 640))
    val wanted = r.nextInt(9)
    val spheres = Iterator
      .continually {
        val radius = between(r, 1, 60)
        val c = within(
          r,
          IntVector(-320 + radius, -240 + radius, -400),
          IntVector(320 - radius, 240 - radius, 640 - radius)
        )
        val touching = if (r.nextInt(4) == 0) IntVector(320 - radius, c.y, c.z) else c
        RaySphere(touching, touching, radius, 0xff0000)
      }
      .take(50)
      .foldLeft(Seq[RaySphere]()) { (kept, s) =>
        def apart(p: IntVector, q: IntVector, d: Int) = (p - q).dot(p - q) > d.toLong * d
        if (
          kept.size < wanted && apart(s.low, eye, s.radius) && kept.forall(k =>
            apart(k.low, s.low, k.radius + s.radius)
          )
        ) kept :+ s
        else kept
      }
    RayScene(
      RayCameraRange(camera),
      room,
      spheres,
      PongScene.room().quads,
      if (r.nextInt(8) == 0) None else Some(light),
      0xffff00
    )
  }
}
