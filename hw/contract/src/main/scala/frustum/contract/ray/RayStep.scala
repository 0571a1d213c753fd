package frustum.contract.ray

import frustum.contract.arithmetic.Interval

/** One step of the set-up: the word at `to` becomes a * b, a + b or a - b of words.
  *
  * @param bits of a multiplication: the word at b is from -2^(bits - 1) to 2^(bits - 1) - 1
  * @param range of the result
  */
case class RayStep(op: Int, to: Int, a: Int, b: Int, bits: Int, range: Interval)

object RayStep {
  val Multiply = 0
  val Add = 1
  val Subtract = 2
}
