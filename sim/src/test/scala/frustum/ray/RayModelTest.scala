package frustum.ray

import frustum.judge.{RayCounts, RayJudge}
import frustum.model.ray.RayPicture
import frustum.spec._
import org.scalatest.funsuite.AnyFunSuite

import scala.util.Random

/** Model against exact arithmetic: no object, silhouette, shadow or cell may differ. */
class RayModelTest extends AnyFunSuite {
  private val (width, height) = (40, 30)
  private val pong            = PongScene.room(width, height, 16)

  private def judge(scene: RayScene, motions: Seq[RayMotion]): Seq[RayCounts] = {
    val (picture, judge) = (new RayPicture(scene, width, height), new RayJudge(scene, width, height))
    motions.map { m =>
      val p = picture(m)
      judge(m, p.map(_.objectId), p.map(_.rgb))
    }
  }

  private def exact(c: RayCounts): Unit = {
    assert(c.silhouettePixelsWrong == 0, c)
    assert(c.shadowPixelsWrong == 0, c)
    assert(c.objectPixelsWrong == 0, c)
    assert(c.checkerCellsWrong == 0, c)
  }

  private def at(x: Int, y: Int, z: Int, px: Int = 0, py: Int = 0) =
    RayMotion(Seq(IntVector(x, y, z)), Seq(IntVector(px, py, 640)))

  test("pong: 300 random places of puck and paddle (seed 1)") {
    val random = new Random(1)
    judge(pong, Seq.fill(300)(RandomScenes.motion(pong, random))).foreach(exact)
  }

  test("pong: puck in the room's corners, at the light, and around it") {
    val corners = for (x <- Seq(-300, 300); y <- Seq(-220, 220); z <- Seq(20, 620)) yield at(x, y, z)
    judge(
      pong,
      corners ++ Seq(at(-120, 200, 160), at(-120, 180, 160), at(-120, 179, 160), at(-100, 200, 160))
    ).foreach(exact)
  }

  test("puck beyond z = 512 shrinks and does not wrap") {
    val areas = Seq(500, 511, 512, 513, 600).map { z =>
      new RayPicture(PongScene.room(160, 120, 4), 160, 120)(at(0, 0, z)).count(_.objectId == 3)
    }
    assert(areas == areas.sorted.reverse && areas.last > 0, areas)
  }

  test("centre rays of either sampling see no division by zero; pixel corners are exact too") {
    val corner = PongScene.room(width, height, 16, centred = false)
    judge(corner, Seq(at(0, 0, 320), at(100, -50, 300))).foreach(exact)
  }

  test("not every pixel hits the puck, and the paddle is not drawn at the puck's place") {
    val p = new RayPicture(pong, width, height)(at(-200, -150, 100, 200, 150))
    assert(p.count(_.objectId == 3) > 0 && p.count(_.objectId == 3) < width * height / 4)
    assert(p.zipWithIndex.filter(_._1.objectId == 2).map(_._2 % width).min > width / 2)
  }

  test("200 random scenes of 0 to 8 spheres, eyes and orientations (seed 2)") {
    val random = new Random(2)
    val scenes = Seq.fill(200)(RandomScenes.scene(random, width, height))
    assert(scenes.map(_.spheres.size).toSet == (0 to 8).toSet)
    for (s <- scenes) judge(s, Seq(RandomScenes.motion(s, random))).foreach(exact)
  }
}
