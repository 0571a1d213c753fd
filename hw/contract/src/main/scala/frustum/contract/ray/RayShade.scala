package frustum.contract.ray

import frustum.contract.arithmetic.FunctionTable
import scala.math.{ceil, max, min, round, sqrt}

/** Formats in which spheres are shaded by a point light, colour * (1/4 + 3/4 max(0, cosine)).
  *
  * With C, r the sphere, E the eye, P the light, w = P - C and u = hit - C the cosine at the hit is u.(P - hit) / (r |P
  * - hit|). As |u| = r, it follows from one number m = u.w - r^2 = u.(P - hit), for |P - hit|^2 = |w|^2 - r^2 - 2 m.
  * With the ray's D, o = C - E, b = D.o, A = |D|^2, discriminant q = b^2 - A (|o|^2 - r^2) and hit = E + D (b - sqrt q)
  * / A:
  * {{{
  * m      = (lit - sqrt(q) D.w) / A,  lit = b D.w - A (o.w + r^2)
  * cosine = m / (r sqrt(power - 2 m)),  power = |w|^2 - r^2
  * }}}
  * q, D.w, lit and A are polynomials of the pixel (see [[RayProgram]]), so nothing is rounded before the root, and the
  * two terms of m are no greater than A r |w|.
  *
  * @param squareLow,squareHigh
  *   least and greatest A of the picture
  */
final class RayShade(scene: RayScene, program: RayProgram, squareLow: Long, squareHigh: Long) {
  private val light = RayBox(scene.light.get)
  val radius: Int = scene.spheres.map(_.radius).max
  private val lightAway = scene.spheres.map(s => s.box.farthest(light)).max
  private def bits(v: Long) = BigInt(v).bitLength
  private def form(name: String) = scene.spheres.indices.map(i => program.form(s"$name$i").width).max

  /** Root of q: q < 2^rootBits, its 16 bits from the [[RayShade.RootWindow]] enter the table; 16 bits of
    * sqrt(q) / 2^(rootBits / 2).
    */
  val rootBits: Int = 2 * ((bits(squareHigh * radius * radius) + 1) / 2)
  val root: FunctionTable = new FunctionTable(true, x => 65536 * sqrt(x))

  /** A m in units of 2^numeratorShift, `numeratorBits` wide. */
  val towardsBits: Int = form("towards")
  val litBits: Int = form("lit")
  val numeratorBits: Int = min(litBits, RayShade.NumeratorBits)
  val numeratorShift: Int = litBits - numeratorBits

  /** sqrt(q) D.w, a product of 16 bits of root, is converted to that by this shift to the right. */
  val productShift: Int = numeratorShift + 16 - rootBits / 2

  /** 1 / A: A < 2^squareBits, 16 bits enter the table, which gives 2^(squareBits + reciprocalShift) / A. */
  val squareBits: Int = bits(squareHigh)
  private val least = max(squareLow, squareHigh / RayShade.SquareRange)
  val reciprocalShift: Int = bits((65535 * least) >> squareBits) - 1
  val reciprocal: FunctionTable = new FunctionTable(false, x => (1 << reciprocalShift) / x)

  /** m with `fraction` bits of fraction; power < 2^powerBits. */
  private val most = ceil(radius * sqrt(lightAway.toDouble)).toLong
  val powerBits: Int = 2 * ((bits(lightAway) + 1) / 2)
  val fraction: Int = RayShade.NumberBits - bits(most)
  val numberBits: Int = RayShade.NumberBits + 2
  val numberShift: Int = reciprocalShift + squareBits - numeratorShift - fraction

  /** 1 / |P - hit|: its square, `distanceBits`, has 16 bits from the [[RayShade.DistanceWindow]] enter the table; m is
    * shifted by half as much and `scaleShift` to the right, so that it fits 16 bits as well. Bits 27..18 of their
    * product are the level.
    */
  val distanceBits: Int = powerBits + fraction
  private val radiusBits = bits(radius)
  val scaleShift: Int = fraction + radiusBits + powerBits / 2 - 16
  val distance: FunctionTable = new FunctionTable(false, x => 4096 / sqrt(x))

  /** Colour of a sphere by level. */
  def ramp(sphere: Int): IndexedSeq[Int] = {
    val s = scene.spheres(sphere)
    val full = RayShade.Levels * s.radius.toDouble / (1 << radiusBits)
    (0 until RayShade.Levels).map { level =>
      val cosine = if (level == 0) 0.0 else min(1.0, (level + 0.5) / full)
      Seq(16, 8, 0).map(c => round((s.color >> c & 255) * (0.25 + 0.75 * cosine)).toInt << c).sum
    }
  }
  require(
    numberShift >= 0,
    s"shading: numbers of ${numberBits} bits are too fine for rays of squared length $squareHigh"
  )
}

/** Small numbers keep their bits by shifts to the left of 0, 1, .. `last` times `step`, while the bits so lost are
  * zero.
  */
case class ShadeWindow(step: Int, last: Int)

object RayShade {
  val NumeratorBits = 24
  val NumberBits = 21
  val LevelBits = 10
  val Levels = 1 << LevelBits
  val LevelShift = 18

  val RootWindow = ShadeWindow(step = 6, last = 1)
  val DistanceWindow = ShadeWindow(step = 4, last = 3)

  /** Rays' squared lengths within a picture may differ by this factor, outside which the reciprocal saturates. */
  val SquareRange = 16

  /** None if there is nothing to shade, or no light. */
  def apply(scene: RayScene, program: RayProgram, width: Int, height: Int): Option[RayShade] =
    if (!scene.shaded || scene.spheres.isEmpty || scene.light.isEmpty) None
    else {
      val (least, most) = scene.camera.squares(width, height)
      Some(new RayShade(scene, program, least.max(1), most.max(1)))
    }
}
