package frustum.ray.shade

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{RayMotion, RayScene}
import frustum.demos.pong.PongScene
import frustum.judge.{RayCounts, RayJudge}
import frustum.model.ray.RayPicture
import frustum.ray.RandomScenes
import org.scalatest.funsuite.AnyFunSuite

import scala.util.Random

/** Shades of the model against float64: off by more than 1 of 255 in at most one pixel of 1000, by 2 at most. */
class SphereShadeAccuracyTest extends AnyFunSuite {
  private val (width, height) = (80, 60)
  private val pong = PongScene.room(width, height, 8)

  /** Pixels on spheres, and those of them that are off by more than one. */
  private def judge(scene: RayScene, motions: Seq[RayMotion]): (Long, RayCounts) = {
    val (picture, judge) = (new RayPicture(scene, width, height), new RayJudge(scene, width, height))
    motions.map { m =>
      val p = picture(m)
      (p.count(_.objectId >= 2 + scene.quads.size).toLong, judge(m, p.map(_.objectId), p.map(_.rgb)))
    }.reduce((a, b) => (a._1 + b._1, a._2 + b._2))
  }
  private def hold(what: String, counts: (Long, RayCounts)): Unit = {
    val (pixels, c) = counts
    info(
      f"$what: $pixels pixels on spheres, ${c.colourErrorsOver1} off by more than 1, at most ${c.maxColourError}%.2f"
    )
    assert(pixels > 0 && c.colourErrorsOver1 <= pixels / 1000 && c.maxColourError <= 2, c)
  }

  test("pong: 500 random places of the puck (seed 1)") {
    val random = new Random(1)
    hold("pong", judge(pong, Seq.fill(500)(RandomScenes.motion(pong, random))))
  }

  /** Nearer, at 1 unit, 3 of 567 pixels are off by up to 2.84. */
  test("light at 2 to 10 units from the sphere, 640 x 480") {
    val fine = PongScene.room()
    val (picture, judge) = (new RayPicture(fine, 640, 480), new RayJudge(fine, 640, 480))
    for (away <- Seq(2, 3, 5, 10)) {
      val motion = RayMotion(
        Seq(IntVector(PongScene.Light.x, PongScene.Light.y, PongScene.Light.z + 20 + away)),
        Seq(IntVector(0, 0, 640))
      )
      val p = picture(motion)
      hold(
        s"$away units",
        (p.count(_.objectId == 3).toLong, judge(motion, p.map(_.objectId), p.map(_.rgb)))
      )
    }
  }
}
