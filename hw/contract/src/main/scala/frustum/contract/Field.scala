package frustum.contract

/** Bits `high` down to `low`, both of them included, of a layout's word `word`. */
final case class Slice(word: Int, high: Int, low: Int) {
  def width: Int = high - low + 1

  /** These bits of the word. */
  def mask: Int = (-1 >>> (32 - width)) << low
}

/** A number of a [[Layout]].
  *
  * @param name    an identifier
  * @param slices  the places of its bits, the most significant first
  * @param signed  two's complement
  * @param meaning unit, range or codes, in a line for the documentation
  */
final case class Field(name: String, slices: Seq[Slice], signed: Boolean, meaning: String) {
  val width: Int = slices.map(_.width).sum
  require(width <= (if (signed) 32 else 31), s"field $name has $width bits")

  def least: Int = if (signed) -1 << (width - 1) else 0
  def greatest: Int = if (signed) ~least else -1 >>> (32 - width)
  def fits(value: Int): Boolean = value >= least && value <= greatest

  /** All bits of the field set, as an unsigned number. */
  def ones: Int = -1 >>> (32 - width)

  /** Its value in `words`. */
  def of(words: Seq[Int]): Int = {
    val bits = slices.foldLeft(0)((v, s) => v << s.width | (words(s.word) & s.mask) >>> s.low)
    if (signed) bits << (32 - width) >> (32 - width) else bits
  }

  /** The lower bits of `value` in their places: words with the bits for each. */
  def placed(value: Int): Seq[(Int, Int)] = {
    val below = slices.scanRight(0)((s, n) => s.width + n).tail // bits of the value below each slice
    slices.zip(below).map { case (s, n) => s.word -> ((value >> n << s.low) & s.mask) }
  }

  /** `word`, that which holds all of the field, with the lower bits of `value` in its place. */
  def into(word: Int, value: Int): Int = word & ~slice.mask | (value << slice.low) & slice.mask

  /** The same field where words of 16 bits are held in pairs, the first in the upper half of a word of 32. */
  def paired: Field = {
    val moved = slices.map { s =>
      val up = if (s.word % 2 == 0) 16 else 0
      Slice(s.word / 2, s.high + up, s.low + up)
    }
    val joined = moved.tail.foldLeft(Vector(moved.head)) { (done, s) =>
      val before = done.last
      if (before.word == s.word && before.low == s.high + 1) done.init :+ before.copy(low = s.low) else done :+ s
    }
    copy(slices = joined)
  }

  /** Its `bits` least significant bits alone, for a value that they can hold. It is in one word. */
  def narrow(bits: Int): Field = copy(slices = Seq(slice.copy(high = slice.low + bits - 1)))

  /** Its place, if that is in one piece. */
  def slice: Slice = {
    require(slices.length == 1, s"field $name is in ${slices.length} pieces")
    slices.head
  }
}
