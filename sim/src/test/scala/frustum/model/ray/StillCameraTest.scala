package frustum.model.ray

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{RayImage, RayMotion, RayQuad, RayScene, RaySolid, RaySphere}
import frustum.contract.video.ColorFormat
import frustum.demos.pong.PongScene
import frustum.model.video.{DitheredScreen, OrderedDither, TextOverlay}
import frustum.contract.video.TextField
import frustum.ray.RandomScenes
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** What is drawn of what moves is the picture that is drawn anew. */
class StillCameraTest extends AnyFunSuite {
  private val (width, height) = (80, 60)
  private val pong = PongScene.room(width, height, 8)

  private def same(scene: RayScene, motions: Seq[RayMotion]): Unit = {
    val (still, whole) = (new StillCamera(scene, width, height), new RayPicture(scene, width, height))
    for (m <- motions) {
      val (is, due) = (still(m), whole(m).map(_.rgb))
      val wrong = due.indices.find(i => is(i) != due(i))
      assert(wrong.isEmpty, wrong.map(i => f"${i % width}, ${i / width}: ${is(i)}%06x, should be ${due(i)}%06x, $m"))
    }
  }
  private def at(x: Int, y: Int, z: Int) = RayMotion(Seq(IntVector(x, y, z)), Seq(IntVector(30, -20, 640)))

  test("pong: 100 random places of puck and paddle (seed 4), corners, and around the light") {
    val random = new Random(4)
    val corners = for (x <- Seq(-300, 300); y <- Seq(-220, 220); z <- Seq(20, 620)) yield at(x, y, z)
    val lights = Seq(at(-120, 200, 160), at(-120, 180, 160), at(-120, 179, 160))
    same(pong, Seq.fill(100)(RandomScenes.motion(pong, random)) ++ corners ++ lights)
  }

  test("several spheres, quads over one another, an image, a dark scene, an unshaded one") {
    val random = new Random(5)
    val image = RayImage(4, 4, 3, IndexedSeq.tabulate(16)(i => i * 0x0f0b07))
    val quads = Seq(
      pong.quads.head.copy(paint = image),
      RayQuad(IntVector(0, 0, 640), IntVector(0, 0, 640), 80, RaySolid(0x40c080))
    )
    val spheres = pong.spheres ++ Seq((-100, 60), (40, -30)).map { case (x, y) =>
      val place = IntVector(x, y, -100)
      RaySphere(place, place, 25, 0x30a0f0)
    }
    val many = pong.copy(quads = quads, spheres = spheres)
    for (scene <- Seq(many, many.copy(light = None), many.copy(shaded = false), pong.copy(spheres = Nil, quads = Nil)))
      same(scene, Seq.fill(20)(RandomScenes.motion(scene, random)))
  }

  test("a whole picture is dithered and written over as its pixels are one by one") {
    val random = new Random(6)
    val rgb = Array.fill(width * height)(random.nextInt(1 << 24))
    val kept = rgb.clone
    val text = TextOverlay(Seq(
      TextField(1, 0, 2, 0) -> Some("42"),
      TextField(1, 1, 4, 1) -> Some("LOSE"),
      TextField(0, 2, 2, 1) -> None
    ))
    for (format <- Seq(ColorFormat.Rgb444, ColorFormat.Rgb565, ColorFormat.Rgb332, ColorFormat.Rgb888)) {
      val due = Array.tabulate(rgb.length) { i =>
        OrderedDither(text(rgb(i), i % width, i / width), format, i % width, i / width)
      }
      assert(new DitheredScreen(width, height, format)(rgb, text).toSeq == due.toSeq, format.name)
    }
    assert(rgb.sameElements(kept))
  }
}
