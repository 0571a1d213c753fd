package frustum.charts.systems

import frustum.boards.{BoardTop, Tops}
import frustum.charts.SphereFamily
import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{RayMotion, RayShade}
import frustum.contract.video.ColorFormat
import frustum.demos.pong.{PongPipelineConfig, PongScene}
import frustum.judge.Flip
import frustum.model.ray.RayPicture
import frustum.model.video.OrderedDither
import frustum.reference.ray.ExactRay
import scala.math.rint

/** Ray casters without a frame buffer: pixels a second, which are a pixel a cycle, against errors of silhouettes, of
  * shading and of the picture at the pins. The picture is pong's room in 160 x 120.
  */
final class RaySystems(tops: BoardTop => (Option[Placed], String)) {
  private val (width, height) = (160, 120)
  private val scene = PongScene.room(width, height, 640 / width)
  private val motion = RayMotion(Seq(IntVector(40, -60, 180)), Seq(IntVector(-100, 40, 640)))
  private val model = new RayPicture(scene, width, height)(motion)
  private val exact = {
    val ray = new ExactRay(scene)
    for (v <- 0 until height; h <- 0 until width) yield ray(motion, h, v)
  }
  private val exactPicture = exact.map(p => rgb(p.rgb.map(rint(_).toInt))).toArray
  private val flip = new Flip(width, height)
  private val sphere = exact.indices.filter(i => exact(i).objectId == 2 + scene.quads.size)
  private val aimed = Tops.find("icebreaker-pong").get.targetMHz.toDouble

  private def rgb(channels: Seq[Int]): Int = channels.foldLeft(0)((c, v) => c << 8 | v.max(0).min(255))

  /** Mean FLIP of the model's picture in a format of the pins. */
  private def flipOf(format: ColorFormat, dither: Boolean): Double = {
    val shown = model.zipWithIndex.map { case (p, at) =>
      rgb(format.channels.zip(Seq(16, 8, 0)).map { case (bits, shift) =>
        val v = p.rgb >> shift & 255
        val code = if (dither) OrderedDither.channel(v, bits, at % width, at / width) else v >> 8 - bits
        rint(code * 255.0 / ((1 << bits) - 1)).toInt
      })
    }
    flip.mean(exactPicture, shown)
  }

  /** Greatest error of a channel of the sphere, of 255. */
  private def worst(shade: Int => Seq[Double]): Double =
    sphere.flatMap(i => exact(i).rgb.zip(shade(i)).map { case (a, b) => (a - b).abs }).max

  /** Of light in so many bits, rounded, on the sphere's own colour. */
  def shadingError(bits: Int): Double = {
    val color = Seq(16, 8, 0).map(scene.spheres.head.color >> _ & 255)
    val steps = (1 << bits) - 1
    worst(i => exact(i).rgb.zip(color).map { case (v, c) => if (c == 0) v else rint(v / c * steps) / steps * c })
  }

  /** Pixels of the sphere's silhouette that the model has wrong, of 100 of the sphere. */
  private def silhouettesWrong: Double = {
    val first = 2 + scene.quads.size
    100.0 * exact.indices.count(i => (exact(i).objectId >= first) != (model(i).objectId >= first)) / sphere.length
  }

  private def point(
      group: String,
      setting: String,
      placed: Option[Placed],
      built: Boolean,
      target: Double,
      errors: (Option[Double], Option[Double], Option[Double])
  ): SystemPoint = {
    val clock = placed.flatMap(_.clockMHz)
    SystemPoint(
      group,
      setting,
      clock.getOrElse(target),
      clock.getOrElse(target),
      clock.isDefined,
      built,
      placed.flatMap(_.cells),
      Seq(errors._1, errors._2, errors._3)
    )
  }

  def chart: SystemChart = {
    val pins = PongPipelineConfig().format
    val shading = worst(i => Seq(16, 8, 0).map(s => (model(i).rgb >> s & 255).toDouble))
    val own = (Some(silhouettesWrong), Some(shading), Some(flipOf(pins, dither = true)))
    def ofTop(top: BoardTop, name: String) =
      point("shipped: exact differences, dithered 444", name, tops(top)._1, built = true, top.targetMHz.toDouble, own)
    val shipped = Seq("icebreaker-pong" -> "iCEBreaker", "arty-pong" -> "Arty A7-35T").flatMap { case (top, board) =>
      Tops.find(top).map(ofTop(_, board))
    } ++ Tops.find("arty-pong").map(t => ofTop(t.onEcp5, "ECP5"))
    def method(group: String, setting: String, silhouettes: Option[Double], shade: Option[Double]) =
      point(group, setting, None, built = false, aimed, (silhouettes, shade, None))
    val floats = Seq(8, 12, 16, 20)
      .map(n => method("discriminant, floating point", s"$n bits", Some(SphereFamily.floatWrong(n)), None))
    val units = Seq(8, 12, 16, 20)
      .map(n => method("discriminant, unit vectors", s"$n bits", Some(SphereFamily.unitWrong(n)), None))
    val shades = Seq(4, 6, 8).map(n => method("bits of light", s"$n bits", None, Some(shadingError(n))))
    val formats = for {
      (dither, how) <- Seq(true -> "dithered", false -> "cut")
      f <- Seq(ColorFormat.Rgb332, ColorFormat.Rgb444, ColorFormat.Rgb565) if f != pins || !dither
    } yield point(
      s"colours at the pins, $how",
      f.name,
      None,
      built = true,
      aimed,
      (None, None, Some(flipOf(f, dither)))
    )
    SystemChart(
      "systems-rays",
      s"Rays: pixels a second against error",
      "million pixels a second: a pixel a cycle of the placed clock",
      Seq("wrong silhouettes, % of the sphere's pixels", "greatest shading error, of 255", "mean FLIP at the pins"),
      (shipped ++ floats ++ units ++ shades ++ formats).toSeq,
      Nil,
      s"The shipped light has ${RayShade.LevelBits} bits. All pipelines take a pixel a cycle, so that the clock " +
        "alone decides the speed. Light in a few bits is exact light, rounded.",
      errorFloor = 1e-4,
      panelHeight = 300
    )
  }
}
