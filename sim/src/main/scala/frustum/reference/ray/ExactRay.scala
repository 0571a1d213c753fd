package frustum.reference.ray

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{RayChecker, RayImage, RayMotion, RayPaint, RayScene, RaySolid}

/** What exact arithmetic says of one ray. `paint` is the colour of the wall or quad that shows, before any shadow;
  * `rgb` components are float64, 0..255.
  */
case class ExactPixel(objectId: Int, shadowed: Boolean, paint: Int, rgb: Seq[Double])

/** Ray casting from the textbook, every decision in whole numbers or fractions of them (BigInt), shading in
  * float64. Knows nothing of polynomials of the pixel.
  */
class ExactRay(scene: RayScene) {
  import scene.room
  private type V = Seq[BigInt]
  private def big(v: IntVector): V = v.axes.map(BigInt(_))
  private def dot(a: V, b: V): BigInt = a.zip(b).map { case (x, y) => x * y }.sum
  private def minus(a: V, b: V): V = a.zip(b).map { case (x, y) => x - y }

  /** Sphere (C, r) and the ray E + t D: (|D|^2, D.(C - E), discriminant) of |E + t D - C|^2 = r^2. */
  private def sphere(e: V, d: V, c: V, r: Int): (BigInt, BigInt, BigInt) = {
    val o = minus(c, e)
    val (a, b) = (dot(d, d), dot(d, o))
    (a, b, b * b - a * (dot(o, o) - BigInt(r).pow(2)))
  }

  /** Whether b - sqrt(q) < s for q >= 0. */
  private def nearRootBelow(b: BigInt, q: BigInt, s: BigInt): Boolean = s > b || (b - s) * (b - s) < q

  def apply(motion: RayMotion, h: Int, v: Int): ExactPixel = {
    val camera = motion.cameraOf(scene)
    val e = big(camera.eye)
    // The ray of a pixel as docs/rays.md defines it: corner + h right + v down.
    val d = (0 to 2).map(a => BigInt(camera.corner(a)) + BigInt(camera.right(a)) * h + BigInt(camera.down(a)) * v)
    val hits = motion.spheres.indices.flatMap { i =>
      val (a, b, q) = sphere(e, d, big(motion.spheres(i)), scene.spheres(i).radius)
      // Both roots positive: the eye is outside, so their product is.
      if (a > 0 && q >= 0 && b > 0) Some((i, b, q)) else None
    }
    val nearest = hits.reduceOption { (m, n) => if (first(n, m)) n else m }
    nearest match {
      case Some((i, b, q)) =>
        ExactPixel(2 + scene.quads.size + i, false, 0, shadeSphere(motion, i, e, d, b, q))
      case None => wall(motion, e, d)
    }
  }

  /** Whether root b - sqrt(q) of the first is below that of the second. */
  private def first(n: (Int, BigInt, BigInt), m: (Int, BigInt, BigInt)): Boolean = {
    // sqrt(qm) - sqrt(qn) < bm - bn; squared twice with the signs kept.
    val (x, p, q) = (m._2 - n._2, m._3, n._3)
    // sqrt(p) < x + sqrt(q)
    val rest = p - x * x - q // against 2 x sqrt(q)
    def sumPositive = x >= 0 || q > x * x
    sumPositive && (if (x >= 0) rest < 0 || rest * rest < 4 * x * x * q
                    else rest < 0 && rest * rest > 4 * x * x * q)
  }

  private def wall(motion: RayMotion, e: V, d: V): ExactPixel = {
    val planes = for (axis <- 0 to 2; high <- Seq(false, true) if axis < 2 || high)
      yield (axis, BigInt(if (high) room.high(axis) else room.low(axis)))
    // Distances (plane - E) / D as fractions with positive denominator.
    val met = planes.flatMap { case (axis, at) =>
      val (n, k) = if (d(axis) < 0) (-d(axis), e(axis) - at) else (d(axis), at - e(axis))
      if (n > 0 && k > 0) Some((axis, at, k, n)) else None
    }
    if (met.isEmpty) return background
    val (axis, at, k, n) = met.reduceLeft((m, x) => if (x._3 * m._4 < m._3 * x._4) x else m)
    val hit = (0 to 2).map(a => e(a) * n + k * d(a)) // times n
    if (hit(2) < n * room.low.z) return background
    val quad =
      if (axis != 2) None
      else motion.quads.indices.find { i =>
        (0 to 1).forall(a => (hit(a) - n * motion.quads(i)(a)).abs <= n * scene.quads(i).half)
      }
    val shadowed = scene.light.exists { p =>
      val light = big(p)
      val toHit = (0 to 2).map(a => hit(a) - n * light(a)) // n (hit - light)
      motion.spheres.indices.exists { i =>
        val (a, b, q) = sphere(light, toHit, big(motion.spheres(i)), scene.spheres(i).radius)
        val c = dot(
          minus(big(motion.spheres(i)), light),
          minus(big(motion.spheres(i)), light)
        ) - BigInt(scene.spheres(i).radius).pow(2)
        // A root within the way from light to hit, whose parameter runs to a / n.
        q >= 0 && (c <= 0 || b > 0 && nearRootBelow(b * n, q * n * n, a))
      }
    }
    val color = quad match {
      case Some(i) =>
        painted(scene.quads(i).paint, motion.quads(i).axes.map(_ - scene.quads(i).half), axis, hit, n)
      case None =>
        // In the order of Wall.all.
        val wall = if (axis == 2) 4 else 2 * axis + (if (at == room.high(axis)) 1 else 0)
        painted(room.paints(wall), room.low.axes, axis, hit, n)
    }
    val full = split(color)
    ExactPixel(quad.fold(1)(2 + _), shadowed, color, if (shadowed) full.map(_ / 2) else full)
  }

  /** What a surface across `axis` shows at hit / n. */
  private def painted(paint: RayPaint, low: Seq[Int], axis: Int, hit: V, n: BigInt): Int = {
    def cell(a: Int) = ((hit(a) - n * low(a)) / (n * (BigInt(1) << paint.cellBits))).toInt
    paint match {
      case RaySolid(color) => color
      case image: RayImage =>
        // Side walls: z to the right, y upwards; floor and ceiling: x and z; back wall: x and y.
        val (column, row) = Seq((2, 1), (0, 2), (0, 1))(axis)
        image.texel(cell(column) % image.width, cell(row) % image.height)
      case RayChecker(_) => (0 to 2).map(a => if (cell(a) % 2 == 1) 0xff << (16 - 8 * a) else 0).sum
    }
  }

  private def background = ExactPixel(0, false, 0, split(scene.background))
  private def split(c: Int): Seq[Double] = Seq(16, 8, 0).map(s => (c >> s & 255).toDouble)

  /** colour (1/4 + 3/4 max(0, n.l)); full colour in a scene without light. */
  private def shadeSphere(motion: RayMotion, i: Int, e: V, d: V, b: BigInt, q: BigInt): Seq[Double] = {
    val color = split(scene.spheres(i).color)
    scene.light.fold(color) { p =>
      val t = (b.toDouble - scala.math.sqrt(q.toDouble)) / dot(d, d).toDouble
      val hit = (0 to 2).map(a => e(a).toDouble + t * d(a).toDouble)
      val n = (0 to 2).map(a => (hit(a) - motion.spheres(i)(a)) / scene.spheres(i).radius)
      val l = (0 to 2).map(a => p(a) - hit(a))
      val length = scala.math.sqrt(l.map(x => x * x).sum)
      val cosine = scala.math.max(0, n.zip(l).map { case (x, y) => x * y }.sum / length)
      color.map(_ * (0.25 + 0.75 * cosine))
    }
  }
}
