package frustum.spec

/** A polynomial of the pixel coordinates, evaluated from left to right by differences: `value` at the next
  * pixel is value + step, and step + curve its step. `registers` of them (1 constant along a row, 2 linear, 3
  * quadratic) are filled by the row load's words from `register` on.
  *
  * @param range
  *   proved range at visible pixels; registers wrap beyond it without harm
  */
case class RayForm(name: String, register: Int, registers: Int, range: Interval) {
  val width: Int = range.width

  /** Place of a register's word in the row load. A quadratic form's words leave a gap before the last, a clock in which
    * its walker moves what it has taken on.
    */
  def slot(i: Int): Int = register + (if (i == 2) 3 else i)
  def loadWords: Int    = if (registers == 3) 4 else registers
}
