package frustum.contract.ray

import frustum.contract.arithmetic.{IntVector, Interval}
import scala.collection.mutable.ArrayBuffer

/** The forms that decide a scene's pixels.
  *
  * With D the ray's direction, a linear form of the pixel, E the eye, and for each sphere o = C - E:
  * {{{
  * sphere   b = D.o > 0 and b^2 - |D|^2 (|o|^2 - r^2) >= 0
  * wall     n = +-D_a > 0, k its distance from E; hit's coordinate u above the room's corner, times n:
  *          (E_u - low_u) n + k D_u, between 0 and (high_u - low_u) n
  * shadow   v = n (E - P) + k D, parallel to light P to hit; S = C - P; v.S > 0 and
  *          (v.S)^2 - |v|^2 (|S|^2 - r^2) >= 0; or the sphere holds the light
  * shade    with w = -S: D.w, b D.w - |D|^2 (o.w + r^2), |D|^2 and |S|^2 - r^2, see [[RayShade]]
  * }}}
  * All are polynomials of the pixel of at most second degree with integer coefficients, so their signs are exact.
  * Ranges: by Cauchy's inequality a discriminant b^2 - A c is between -A c and A r^2, D.w within |D| |w|, and where the
  * sphere is hit b D.w - A (o.w + r^2) within A (r |w| + r^2); elsewhere that one wraps.
  */
class RaySceneForms(scene: RayScene, width: Int, height: Int) {
  import scene.{camera, room}
  val builder = new RayProgramBuilder
  private val b = builder
  private val algebra = new RayAlgebra(b, width, height)
  import algebra._

  /** Coordinates that move. */
  val inputs = ArrayBuffer[(RayMoving, Int, RayWord)]()

  /** Polynomials needed, by name, with their proved range. */
  val wanted = ArrayBuffer[(String, RayPolynomial, Interval)]()

  private def moving(of: RayMoving): Seq[RayWord] = {
    val box = of.in(scene)
    (0 to 2).map { a =>
      if (box.low(a) == box.high(a)) b.constant(box.low(a))
      else {
        val w = new RayWord(Interval(box.low(a), box.high(a)), None)
        inputs += ((of, a, w))
        w
      }
    }
  }
  private val Seq(eye, corner, right, down) = camera.low.vectors.indices.map(i => moving(RayMoving.Camera(i)))
  private val centres = scene.spheres.indices.map(i => moving(RayMoving.Sphere(i)))
  private val quads = scene.quads.indices.map(i => moving(RayMoving.Quad(i)))

  private val longest = camera.lengths.map(_._2)
  private val direction =
    (0 to 2).map(a => linear(corner(a), right(a), down(a), longest.map(l => Interval(-l, l))))
  private def point(p: IntVector) = p.axes.map(x => b.constant(x))
  private def minus(p: Seq[RayWord], q: Seq[RayWord]) = p.zip(q).map { case (x, y) => b.subtract(x, y) }
  private def dotWords(p: Seq[RayWord], q: Seq[RayWord]) =
    p.zip(q).map { case (x, y) => b.multiply(x, y) }.reduce(b.add)

  /** A wall's distance from the eye along its axis, positive. */
  private def distance(w: Wall): RayWord = {
    val position = b.constant(w.position(room))
    if (w.sign > 0) b.subtract(position, eye(w.axis)) else b.subtract(eye(w.axis), position)
  }
  private def normal(w: Wall) = scale(direction(w.axis), b.constant(w.sign))

  private def wantWithin(name: String, p: RayPolynomial, r: Interval): Unit = wanted += ((name, p, r))
  private def want(name: String, p: RayPolynomial): Unit = wantWithin(name, p, p.bound)

  /** Upper bound of |v|^2, the sum of its components' bounds. */
  private def most(v: Seq[RayPolynomial]) = v.map(_.bound.square).reduce(_ + _).high

  private val square = direction.map(algebra.square).reduce(add)
  private val squareMost = longest.fold(most(direction))(l => most(direction).min(BigInt(l) * l))

  private def discriminant(
      name: String,
      v: Seq[RayPolynomial],
      vMost: BigInt,
      s: Seq[RayWord],
      radius: Int
  ): (RayPolynomial, RayWord) = {
    val r2 = BigInt(radius).pow(2)
    val c = b.subtract(dotWords(s, s), b.constant(r2))
    val along = dot(v, s)
    val a = v.map(algebra.square).reduce(add)
    val cMost = s.map(_.range.square).reduce(_ + _).high
    wantWithin(name, subtract(algebra.square(along), scale(a, c)), Interval(-vMost * cMost, vMost * r2))
    (along, c)
  }

  /** Upper bound of |v|^2 for a shadow's v = n (E - P) + k D, with |n| <= |D|. */
  private def shadowMost(v: Seq[RayPolynomial], w: Wall, light: IntVector) = longest.fold(most(v)) { l =>
    val far = upTo(BigInt(scene.eye.farthest(RayBox(light)))) + distance(w).range.high
    most(v).min((BigInt(l) * far).pow(2))
  }
  private def upTo(square: BigInt) = BigInt(scala.math.ceil(scala.math.sqrt(square.toDouble)).toLong + 1)

  /** What a sphere's shade needs in addition to its discriminant; `away` is from its centre to the light. */
  private def wantShade(i: Int, centre: Seq[RayWord], along: RayPolynomial, away: Seq[RayWord]): Unit = {
    def within(m: BigInt) = Interval(-m, m)
    val r = BigInt(scene.spheres(i).radius)
    val far = away.map(_.range.square).reduce(_ + _).high
    val towards = dot(direction, away)
    val across = dotWords(minus(centre, eye), away)
    wantWithin(s"towards$i", towards, within(upTo(squareMost * far)))
    wantWithin(
      s"lit$i",
      subtract(product(along, towards), scale(square, b.add(across, b.constant(r * r)))),
      within(squareMost * (r * upTo(far) + r * r))
    )
  }

  for (a <- 0 to 2) want(s"direction$a", direction(a))
  if (scene.shaded && scene.light.isDefined && scene.spheres.nonEmpty)
    wantWithin("square", square, Interval(0, squareMost))
  for (w <- Wall.all; u <- w.across)
    want(
      s"across${w.index}_$u",
      add(scale(normal(w), b.subtract(eye(u), b.constant(room.low(u)))), scale(direction(u), distance(w)))
    )
  for ((p, q) <- Wall.pairs if p.sign > 0 && q.sign > 0)
    want(
      s"before${p.index}_${q.index}",
      subtract(scale(direction(p.axis), distance(q)), scale(direction(q.axis), distance(p)))
    )
  for ((q, i) <- quads.zipWithIndex; u <- 0 to 1) {
    val half = scene.quads(i).half
    val offset = b.add(b.subtract(eye(u), q(u)), b.constant(half))
    val low = add(scale(direction(2), offset), scale(direction(u), distance(Wall.back)))
    want(s"quad${i}_$u", low)
    want(s"quadEnd${i}_$u", subtract(scale(direction(2), b.constant(2 * half)), low))
  }
  for ((centre, i) <- centres.zipWithIndex) {
    val radius = scene.spheres(i).radius
    val (along, _) = discriminant(s"sphere$i", direction, squareMost, minus(centre, eye), radius)
    want(s"along$i", along)
    for (light <- scene.light) {
      val s = minus(centre, point(light))
      if (scene.shaded) wantShade(i, centre, along, minus(point(light), centre))
      for (w <- Wall.all) {
        val v = (0 to 2).map { a =>
          add(scale(normal(w), b.subtract(eye(a), b.constant(light(a)))), scale(direction(a), distance(w)))
        }
        val (gate, c) = discriminant(s"shadow${i}_${w.index}", v, shadowMost(v, w, light), s, radius)
        want(s"gate${i}_${w.index}", gate)
        if (w == Wall.back) wantWithin(s"power$i", constant(c), c.range)
      }
    }
  }
}
