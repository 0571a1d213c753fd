package frustum.contract.arithmetic

/** Integers from `low` to `high`; the arithmetic by which ranges and widths are proved. */
case class Interval(low: BigInt, high: BigInt) {
  require(low <= high, s"interval from $low to $high")
  def +(o: Interval): Interval = Interval(low + o.low, high + o.high)
  def -(o: Interval): Interval = Interval(low - o.high, high - o.low)
  def *(o: Interval): Interval = {
    val corners = for (a <- Seq(low, high); b <- Seq(o.low, o.high)) yield a * b
    Interval(corners.min, corners.max)
  }
  def square: Interval = {
    val most = (low * low).max(high * high)
    Interval(if (low <= 0 && high >= 0) 0 else (low * low).min(high * high), most)
  }

  /** The intersection. */
  def within(o: Interval): Interval = Interval(low.max(o.low), high.min(o.high))
  def contains(v: BigInt): Boolean = low <= v && v <= high

  /** Bits of two's complement that hold it. */
  def width: Int = low.bitLength.max(high.bitLength) + 1
}

object Interval {
  def apply(v: BigInt): Interval = Interval(v, v)
}
