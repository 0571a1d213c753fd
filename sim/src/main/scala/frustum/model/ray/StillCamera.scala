package frustum.model.ray

import frustum.contract.ray.{RayMotion, RayProgram, RayScene, RayShade, RaySolid, Wall}
import frustum.model.ray.program.RayRows
import frustum.model.ray.shade.SphereShade

/** The colours of [[RayPicture]], of a camera that stands still, picture after picture: walls without anything before
  * them are drawn once, so that a picture costs what moves, spheres, shadows and quads.
  */
final class StillCamera(scene: RayScene, width: Int, height: Int) {
  require(scene.camera.fixed, s"the camera moves from ${scene.camera.low} to ${scene.camera.high}")
  private val program = RayProgram(scene, width, height)
  private val rows = new RayRows(program, scene, width, height)

  private val empty = scene.copy(spheres = Nil, quads = Nil, light = None)
  private def drawn(s: RayScene) = new RayPicture(s, width, height)(RayMotion(Nil, Nil)).map(_.rgb)
  private val walls = drawn(empty)

  /** Runs of pixels of a row that show the same wall, its number first; those without a wall are left out. */
  private val runs: Array[Array[(Int, Int, Int)]] = {
    val numbered =
      drawn(empty.copy(
        background = Wall.all.length,
        room = empty.room.copy(paints = Wall.all.map(w => RaySolid(w.index)))
      ))
    numbered.grouped(width).map { row =>
      val starts = row.indices.filter(x => x == 0 || row(x) != row(x - 1))
      starts.zip(
        starts.tail :+ width
      ).map { case (from, to) => (row(from), from, to) }.filter(_._1 < Wall.all.length).toArray
    }.toArray
  }

  private val depth = rows("direction2")
  private val quads =
    scene.quads.indices.map(i => Seq("quad", "quadEnd").map(n => (0 to 1).map(u => rows(s"$n${i}_$u"))))
  private val format = RayShade(scene, program, width, height)
  private val shade = format.map(new SphereShade(_))

  private final class Ball(i: Int) {
    val hit = rows(s"sphere$i")
    val along = rows(s"along$i")
    val shaded = shade.map { _ =>
      (Seq(s"towards$i", s"lit$i", "square", s"power$i").map(rows(_)).toArray, format.get.ramp(i).toArray)
    }
    val shadows =
      if (scene.light.isEmpty) Array.empty[(Int, Int)]
      else Wall.all.map(w => (rows(s"shadow${i}_${w.index}"), rows(s"gate${i}_${w.index}"))).toArray
    val power = if (scene.light.isEmpty) -1 else rows(s"power$i")

    /** Colour where it is hit. */
    def color(x: Int): Int = shaded.fold(scene.spheres(i).color) { case (Array(towards, lit, square, power), ramp) =>
      ramp(shade.get(rows.at(hit, x), rows.at(towards, x), rows.at(lit, x), rows.at(square, x), rows.at(power, x)))
    }
  }
  private val balls = scene.spheres.indices.map(new Ball(_)).toArray

  private val shadowed = new Array[Boolean](width)
  private val nearest = new Array[Long](width)
  private val before = new Array[Int](width) // the sphere that shows

  /** 0xRRGGBB, row by row. */
  def apply(motion: RayMotion): Array[Int] = {
    val picture = walls.clone
    rows.frame(motion)
    for (y <- 0 until height) {
      rows.row()
      for ((wall, from, to) <- runs(y)) {
        if (wall == Wall.back.index) drawQuads(picture, y, from, to)
        drawShadows(picture, y, wall, from, to)
      }
      drawBalls(picture, y)
    }
    picture
  }

  private def drawQuads(picture: Array[Int], y: Int, from: Int, to: Int): Unit =
    for (i <- quads.indices.reverse) { // the first is drawn over the others
      val Seq(low, end) = quads(i)
      var x = from
      while (x < to) {
        if (low.forall(rows.at(_, x) >= 0) && end.forall(rows.at(_, x) >= 0))
          picture(y * width + x) =
            SurfacePaint(scene.quads(i).paint, Wall.back, scene.room, u => rows.at(low(u), x), rows.at(depth, x))
        x += 1
      }
    }

  private def drawShadows(picture: Array[Int], y: Int, wall: Int, from: Int, to: Int): Unit =
    if (scene.light.isDefined) {
      java.util.Arrays.fill(shadowed, from, to, false)
      for (ball <- balls)
        if (rows.at(ball.power, 0) <= 0) java.util.Arrays.fill(shadowed, from, to, true) // it holds the light
        else {
          val (form, gate) = ball.shadows(wall)
          var value = rows.at(form, from)
          var step = rows.step(form, from)
          val curve = rows.curve(form)
          var x = from
          while (x < to) {
            if (value >= 0 && rows.at(gate, x) > 0) shadowed(x) = true
            value += step
            step += curve
            x += 1
          }
        }
      for (x <- from until to if shadowed(x)) picture(y * width + x) = SurfacePaint.darkened(picture(y * width + x))
    }

  private def drawBalls(picture: Array[Int], y: Int): Unit = {
    java.util.Arrays.fill(before, -1)
    for (i <- balls.indices) {
      val ball = balls(i)
      var value = rows.at(ball.hit, 0)
      var step = rows.step(ball.hit, 0)
      val curve = rows.curve(ball.hit)
      var x = 0
      while (x < width) {
        if (value >= 0) {
          val along = rows.at(ball.along, x)
          if (along > 0 && (before(x) < 0 || along < nearest(x))) {
            nearest(x) = along
            before(x) = i
          }
        }
        value += step
        step += curve
        x += 1
      }
    }
    for (x <- 0 until width if before(x) >= 0) picture(y * width + x) = balls(before(x)).color(x)
  }
}
