package frustum.contract.arithmetic

/** Words of a table that gives f(x), x in [0, 1) as 16 bits, f in 0..65535: 256 intervals, each a line between its
  * ends. Hardware and model read the same words.
  *
  * With i the upper byte of x and j the lower: `(base(i) * 2^16 +- slope(i) * 256 j + 2^15) >> 16`, + for a function
  * that rises, - for one that falls. x is taken as cut from more bits, so f is that of half a step above; it is held
  * within 0..65535. Error: that of the line, (1/256)^2 / 8 |f''|, and one unit of rounding.
  */
final class FunctionTable(val rises: Boolean, f: Double => Double) {
  private val ends = Array.tabulate(257) { i =>
    scala.math.round(f(i / 256.0 + 1.0 / (1 << 17)).max(0).min(65535)).toInt
  }
  val base: Array[Int] = ends.init
  val slope: Array[Int] =
    ends.sliding(2).map { case Array(from, to) => if (rises) to - from else from - to }.toArray
  require(slope.forall(_ >= 0), s"a function that does not ${if (rises) "rise" else "fall"} throughout")

  def apply(x: Int): Int = {
    require(x >= 0 && x < (1 << 16), s"x = $x")
    val step = slope(x >> 8).toLong * ((x & 255) << 8)
    (((base(x >> 8).toLong << 16) + (if (rises) step else -step) + (1 << 15)) >> 16).toInt
  }
}
