package frustum.ray

import frustum.judge.{RayCounts, RayJudge}
import frustum.model.ray.RayPicture
import frustum.spec._
import org.scalatest.funsuite.AnyFunSuite

import scala.util.Random

/** Shades of the model against float64: off by more than 1 of 255 in at most one pixel of 1000, by 2 at most. */
class SphereShadeAccuracyTest extends AnyFunSuite {
  private val (width, height) = (80, 60)
  private val pong            = PongScene.room(width, height, 8)

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
    info(f"$what: $pixels pixels on spheres, ${c.colourErrorsOver1} off by more than 1, at most ${c.maxColourError}%.2f")
    assert(pixels > 0 && c.colourErrorsOver1 <= pixels / 1000 && c.maxColourError <= 2, c)
  }

  test("pong: 500 random places of the puck (seed 1)") {
    val random = new Random(1)
    hold("pong", judge(pong, Seq.fill(500)(RandomScenes.motion(pong, random))))
  }
  test("light at 1 to 10 units from the sphere") {
    for (away <- 1 to 10) {
      val at = PongScene.Light
      val m = Seq(IntVector(at.x, at.y, at.z + 20 + away), IntVector(at.x, at.y - 20 - away, at.z), IntVector(at.x + 20 + away, at.y, at.z))
      val fine = PongScene.room(640, 480)
      val (picture, judge) = (new RayPicture(fine, 640, 480), new RayJudge(fine, 640, 480))
      for (p <- m) { val x = picture(RayMotion(Seq(p), Seq(IntVector(0, 0, 640))))
        val c = judge(RayMotion(Seq(p), Seq(IntVector(0, 0, 640))), x.map(_.objectId), x.map(_.rgb))
        info(s"$away ${c.maxColourError} ${c.colourErrorsOver1} of ${x.count(_.objectId == 3)}")
      }
    }
  }
}
