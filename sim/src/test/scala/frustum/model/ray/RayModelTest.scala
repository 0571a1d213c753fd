package frustum.model.ray

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{RayCamera, RayCameraRange, RayImage, RayMotion, RayRoom, RayScene, RaySphere, Wall}
import frustum.demos.pong.PongScene
import frustum.judge.{RayCounts, RayJudge}
import frustum.ray.RandomScenes
import org.scalatest.funsuite.AnyFunSuite

import scala.util.Random

/** Model against exact arithmetic: no object, silhouette, shadow or cell may differ. */
class RayModelTest extends AnyFunSuite {
  private val (width, height) = (40, 30)
  private val pong = PongScene.room(width, height, 16)

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

  test("a sphere behind the eye is not drawn") {
    val behind = IntVector(0, 0, -400)
    val scene = pong.copy(spheres = Seq(RaySphere(behind, behind, 20, 0xff0000)))
    val seen = new RayPicture(scene, width, height)(RayMotion(Seq(behind), Seq(IntVector(0, 0, 640))))
    assert(!seen.exists(_.objectId == 3))
  }

  test("the back wall is 960 away: so wide the paddle looks") {
    val fine = new RayPicture(PongScene.room(), 640, 480)(at(-300, -220, 20))
    val row = (0 until 640).filter(h => fine(240 * 640 + h).objectId == 2)
    // Half a size of 50 at 960, in pixels 320 before the eye: 16.67.
    assert(row == (303 to 336), row)
  }

  test("walls end at the room's front: beyond it nothing is hit") {
    val back = RayCamera(
      IntVector(0, 0, 320),
      IntVector(39 * 16, 29 * 16, -640),
      IntVector(-32, 0, 0),
      IntVector(0, -32, 0)
    )
    val scene = pong.copy(camera = RayCameraRange(back), spheres = Nil)
    val seen = new RayPicture(scene, width, height)(RayMotion(Nil, Seq(IntVector(0, 0, 640))))
    // The front, 640 x 480 at a distance of 320, fills the picture.
    assert(seen.forall(p => p.objectId == 0 && p.rgb == 0xffff00))
    val nearer = scene.copy(camera = RayCameraRange(back.copy(eye = IntVector(0, 0, 480))))
    val walls = new RayPicture(nearer, width, height)(RayMotion(Nil, Seq(IntVector(0, 0, 640))))
    assert(walls.count(_.objectId == 0) == 26 * 20 && walls(0).objectId == 1)
    judge(nearer, Seq(RayMotion(Nil, Seq(IntVector(0, 0, 640))))).foreach(exact)
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

  for (inside <- Seq(false, true))
    test(s"a camera that moves and turns, ${if (inside) "in" else "before"} the room, 150 frames (seed 3)") {
      val random = new Random(3)
      val scene = RandomScenes.moving(width, height, 16, inside)
      val motions = Seq.fill(150)(
        RandomScenes.motion(scene, random).copy(camera =
          Some(RandomScenes.camera(scene, random, width, height, 16))
        )
      )
      val counts = judge(scene, motions)
      counts.foreach(exact)
      assert(counts.map(_.maxColourError).max <= 2, counts.maxBy(_.maxColourError))
    }

  test("a camera beyond what is declared is refused with the numbers; so is one that moves without lengths") {
    val scene = RandomScenes.moving(width, height, 16, inside = false)
    val camera = RandomScenes.camera(scene, new Random(4), width, height, 16)
    val still = PongScene.room(width, height, 16).camera.low
    def refused(c: Option[RayCamera]) =
      intercept[IllegalArgumentException](new RayPicture(scene, width, height)(at(0, 0, 320).copy(camera =
        c
      ))).getMessage
    assert(refused(Some(camera.copy(eye =
      IntVector(0, 101, -200)
    ))).contains("eye (0, 101, -200), accepted (-100, -100, -320)"))
    assert(refused(Some(camera.copy(corner = IntVector(1, 2, 3)))).contains("accepted 550 to"))
    assert(refused(None).contains("needs one"))
    val e =
      intercept[IllegalArgumentException](RayCameraRange(still, still.copy(eye = IntVector(9, 9, 9)), None))
    assert(e.getMessage.contains("length"))
  }

  test("solid walls, checkers of several sizes and images, on walls and quads: 60 random scenes (seed 5)") {
    val random = new Random(5)
    for (_ <- 1 to 60) {
      val scene = RandomScenes.painted(RandomScenes.scene(random, width, height), random)
      judge(scene, Seq(RandomScenes.motion(scene, random))).foreach(exact)
    }
  }

  test("an image's top row is at the top, its left column at the left, seen on each wall") {
    // Four texels as large as the wall's halves.
    val image = RayImage(2, 2, 9, IndexedSeq(0xff0000, 0x00ff00, 0x0000ff, 0xffffff))
    val scene = pong.copy(
      room = RayRoom(IntVector(-512, -512, 0), IntVector(512, 512, 1024), Wall.all.map(_ => image)),
      spheres = Nil,
      quads = Nil
    )
    val seen = new RayPicture(scene, width, height)(RayMotion(Nil, Nil))
    def rgb(x: Int, y: Int) = seen(y * width + x).rgb
    assert(Seq(rgb(18, 13), rgb(21, 13), rgb(18, 16), rgb(21, 16)) == image.rgb) // the back wall
    assert(rgb(0, 14) == 0xff0000 && rgb(0, 15) == 0x0000ff) // the left wall, nearer half
  }
}
