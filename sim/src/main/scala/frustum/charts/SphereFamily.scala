package frustum.charts

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.RayProgram
import frustum.contract.video.VideoMode
import frustum.demos.pong.PongScene
import frustum.ray.walk.FormWalker
import frustum.synthesis.UnitCosts
import scala.math.{getExponent, rint, scalb, sqrt}
import scala.util.Random

/** Tests of a ray against a sphere: the sign of a discriminant, in numbers of so many bits, pixel by pixel.
  *
  * "Floating point" rounds every sum and product to a mantissa of n bits; "unit vectors" takes rays of length 1 of n
  * fraction bits, so that a product less is needed, and sums them exactly. Exact are the whole numbers that the library
  * steps from pixel to pixel.
  */
object SphereFamily extends ChartFamily {
  val name = "spheres"

  private val mode = VideoMode.Vga640x480
  private val scene = PongScene.room(mode.width, mode.height)
  private val camera = scene.camera.low
  private val sphere = scene.spheres.head

  private lazy val centres: Seq[IntVector] = {
    val random = new Random(1)
    def between(axis: Int) = random.between(sphere.low(axis), sphere.high(axis) + 1)
    Seq.fill(6)(IntVector(between(0), between(1), between(2)))
  }

  private type Test = (Seq[Double], Seq[Double]) => Boolean // of a direction and a centre from the eye
  private def squareOfRadius = sphere.radius.toDouble * sphere.radius
  private def dot(a: Seq[Double], b: Seq[Double]) = a.zip(b).map { case (x, y) => x * y }.sum

  private def exact: Test = (d, c) => { // below 2^53, or the test that counts none wrong would fail
    val (a, b) = (big(d, d), big(d, c))
    b > 0 && b * b >= a * (big(c, c) - BigInt(sphere.radius).pow(2))
  }
  private def big(a: Seq[Double], b: Seq[Double]) = a.zip(b).map { case (x, y) =>
    BigInt(x.toLong) * y.toLong
  }.sum

  private def float(bits: Int): Test = {
    def r(v: Double) = if (v == 0) v else { val e = bits - 1 - getExponent(v); scalb(rint(scalb(v, e)), -e) }
    def inner(a: Seq[Double], b: Seq[Double]) =
      a.zip(b).map { case (x, y) => r(x * y) }.reduce((x, y) => r(x + y))
    (d, c) => {
      val (a, b) = (inner(d, d), inner(d, c))
      b > 0 && r(r(b * b) - r(a * r(inner(c, c) - squareOfRadius))) >= 0
    }
  }

  private def unit(bits: Int): Test = (d, c) => {
    val length = sqrt(dot(d, d))
    val n = d.map(x => scalb(rint(scalb(x / length, bits)), -bits))
    val b = dot(n, c)
    b > 0 && b * b - (dot(c, c) - squareOfRadius) >= 0
  }

  /** Pixels on the wrong side of a silhouette, of 100 pixels of spheres. */
  private def wrongPercent(test: Test): Double = {
    var (wrong, inside) = (0L, 0L)
    for (centre <- centres; v <- 0 until mode.height by 3; h <- 0 until mode.width) {
      val d = camera.direction(h, v).axes.map(_.toDouble)
      val c = (0 to 2).map(a => (centre(a) - camera.eye(a)).toDouble)
      val truth = exact(d, c)
      if (truth) inside += 1
      if (test(d, c) != truth) wrong += 1
    }
    100.0 * wrong / inside
  }
  def floatWrong(bits: Int): Double = wrongPercent(float(bits))
  def unitWrong(bits: Int): Double = wrongPercent(unit(bits))

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val program = RayProgram(scene, mode.width, mode.height)
    val form = program.form("sphere0")
    val walker = costs.map(_.timed("walker of a silhouette")(FormWalker(form, program)))
    val points =
      (8 to 28 by 4).map(n => ChartPoint("discriminant in floating point", s"$n bits", n, floatWrong(n))) ++
        (8 to 24 by 4).map(n => ChartPoint("discriminant with unit vectors", s"$n bits", n, unitWrong(n)))
    val ours = ChartPoint("exact, by differences", s"${form.width} bits", form.width, 0, walker)
    Seq(Chart(
      "sphere-tests",
      "Silhouettes of spheres, 640 x 480",
      "bits of a number",
      "wrong pixels, % of the spheres'",
      points :+ ours,
      Some(ours),
      None,
      1e-3,
      "None wrong is drawn at the lower end. The discriminants take seven to ten products a pixel and, for unit " +
        "vectors, a reciprocal root; the differences take two additions" + walker.fold(".")(u =>
          s": ${u.luts} LUT and ${u.flipFlops} flip-flops."
        )
    ))
  }
}
