package frustum.contract

/** Where a method keeps its promise. `./sbt stability` measures each, within and beyond.
  *
  * @param method   what is relied on
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
