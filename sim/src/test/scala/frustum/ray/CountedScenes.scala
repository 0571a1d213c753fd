package frustum.ray

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{
  RayCamera,
  RayCameraRange,
  RayChecker,
  RayImage,
  RayPaint,
  RayQuad,
  RayRoom,
  RayScene,
  RaySolid,
  RaySphere,
  Wall
}
import frustum.contract.video.VideoMode

/** Scenes with a given number of each kind of object, small enough for any of these numbers. */
object CountedScenes {
  private val (width, height) = (24, 12)

  /** Blanks long enough for the set-up of every number of objects. */
  val mode: VideoMode =
    VideoMode("24x12", 25.175, width, height, 16, 96, 8000, 40, 40, 120, hPositive = false, vPositive = false)

  private val low = IntVector(-64, -48, 0)
  private val high = IntVector(64, 48, 128)

  /** The first `moving` spheres and quads go from side to side by a few units; the others stand still. */
  def apply(
      spheres: Int = 0,
      quads: Int = 0,
      light: Boolean = true,
      shaded: Boolean = true,
      moving: Int = 0,
      paints: Seq[RayPaint] = Wall.all.map(_ => RayChecker(4))
  ): RayScene = {
    def to(index: Int, from: IntVector) = if (index < moving) IntVector(from.x + 3, from.y + 2, from.z) else from
    val balls = (0 until spheres).map { i =>
      val centre = IntVector(-48 + 30 * (i % 4), if (i < 4) -20 else 20, 60 + 8 * (i % 3))
      RaySphere(centre, to(i, centre), 8 + i % 3, 0x3050c0 + 0x123456 * i & 0xffffff)
    }
    val squares = (0 until quads).map { i =>
      val centre = IntVector(-40 + 24 * i, 10 * (i % 2) - 5, high.z)
      RayQuad(centre, to(i, centre), 14, if (i % 2 == 0) RaySolid(0xffffff - 0x302010 * i) else image(i))
    }
    RayScene(
      RayCameraRange(RayCamera.forward(IntVector(0, 0, -64), width, height, 64, 8)),
      RayRoom(low, high, paints),
      balls,
      squares,
      if (light) Some(IntVector(-20, 30, 20)) else None,
      0xffff00,
      shaded
    )
  }

  /** Images of every shape, a single texel and a single row or column among them. */
  def image(n: Int): RayImage = {
    val (w, h) = Seq((4, 8), (1, 1), (8, 1), (1, 4), (2, 2))(n % 5)
    RayImage(w, h, 2 + n % 3, IndexedSeq.tabulate(w * h)(i => 0x10203 * (40 * i + 17 * n + 1) & 0xffffff))
  }

  /** So many checkers, then so many images; the other walls have one colour. */
  def paints(checkers: Int, images: Int): Seq[RayPaint] = Wall.all.map { w =>
    if (w.index < checkers) RayChecker(4)
    else if (w.index < checkers + images) image(w.index - checkers)
    else RaySolid(0x204060 * (w.index + 1) & 0xffffff)
  }
}
