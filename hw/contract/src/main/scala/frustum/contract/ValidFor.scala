package frustum.contract

/** The range within which a method keeps its error bound. `./sbt stability` measures each, inside and outside.
  *
  * @param method   the method and what it is used for
  * @param quantity what it depends on, in `unit`
  * @param low,high range of the quantity, both ends included
  * @param bound    greatest error within it, in `errorUnit`
  */
final case class ValidFor(
    method: String,
    quantity: String,
    unit: String,
    low: Double,
    high: Double,
    bound: Double,
    errorUnit: String
) {
  require(low <= high, s"$method: $quantity from $low to $high")
  def contains(value: Double): Boolean = low <= value && value <= high
}
