package frustum.contract.ray

import frustum.contract.arithmetic.Interval

/** A polynomial of the pixel coordinates, evaluated from left to right by differences: `value` at the next pixel is
  * value + step, and step + curve its step. Only what is not a constant is loaded at a row's start, by the row load's
  * words from `first` on; if a difference is not a constant, those before it are not counted as constants either.
  *
  * @param start
  *   value, step and curve at a row's start, as many as the form has; Some where the same for all rows of all frames
  * @param range
  *   proved range at visible pixels; outside of it registers wrap without effect on a pixel
  */
case class RayForm(name: String, first: Int, start: Seq[Option[BigInt]], range: Interval) {
  val width: Int = range.width

  /** 1 value, 2 step, 3 curve. */
  val registers: Int = start.size

  /** How many of them are loaded; a quadratic form's step is a register that changes, and is loaded with its value. */
  val loaded: Int = {
    val variable = start.lastIndexWhere(_.isEmpty) + 1
    if (variable == 1 && registers == 3) 2 else variable
  }

  /** Place of a register's word in the row load, after `first`. Words of a quadratic form leave a gap before the last,
    * a cycle in which its walker adds what it has loaded.
    */
  def slot(i: Int): Int = if (registers == 3 && i == loaded - 1) i + 1 else i
  val loadWords: Int = if (loaded == 0) 0 else slot(loaded - 1) + 1
}
