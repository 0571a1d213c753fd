package frustum.spec

/** A polynomial of the pixel coordinates, evaluated from left to right by differences: `value` at the next
  * pixel is value + step, and step + curve its step. `registers` of them (1 constant along a row, 2 linear, 3
  * quadratic) stand from `register` on in the order of the row load.
  *
  * @param range
  *   proved range at visible pixels; registers wrap beyond it without harm
  */
case class RayForm(name: String, register: Int, registers: Int, range: Interval) {
  val width: Int = range.width
}
