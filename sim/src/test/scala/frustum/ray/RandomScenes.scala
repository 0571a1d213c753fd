package frustum.ray

import frustum.spec._

import scala.util.Random

/** Scenes and motions drawn from a seed. */
object RandomScenes {
  private def between(r: Random, low: Int, high: Int): Int                  = low + r.nextInt(high - low + 1)
  private def within(r: Random, low: IntVector, high: IntVector): IntVector =
    IntVector(between(r, low.x, high.x), between(r, low.y, high.y), between(r, low.z, high.z))

  def motion(scene: RayScene, r: Random): RayMotion =
    RayMotion(
      scene.spheres.map(s => within(r, s.low, s.high)),
      scene.quads.map(q => within(r, q.low, q.high))
    )

  /** Room of pong, other eye, orientation, light and up to 8 spheres that stand apart: near the eye, behind it,
    * touching walls.
    */
  def scene(r: Random, width: Int, height: Int): RayScene = {
    val room         = PongScene.room().room
    val eye          = IntVector(between(r, -200, 200), between(r, -200, 200), between(r, -320, 300))
    def axis(n: Int) = IntVector(between(r, -n, n), between(r, -n, n), between(r, -n, n))
    val camera       = RayCamera(
      eye,
      IntVector(between(r, -600, 600), between(r, -600, 600), between(r, -200, 600)),
      axis(32),
      axis(32)
    )
    val light   = IntVector(between(r, -300, 300), between(r, -220, 220), between(r, 0, 640))
    val wanted  = r.nextInt(9)
    val spheres = Iterator
      .continually {
        val radius = between(r, 1, 60)
        val c      = within(
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
      camera,
      room,
      spheres,
      PongScene.room().quads,
      if (r.nextInt(8) == 0) None else Some(light),
      0xffff00
    )
  }
}
