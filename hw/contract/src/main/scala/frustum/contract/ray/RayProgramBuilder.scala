package frustum.contract.ray

import frustum.contract.arithmetic.Interval
import scala.collection.mutable.{ArrayBuffer, HashMap, LinkedHashMap}

/** A number of the set-up, in its memory from its computation to its last use; or a constant. */
class RayWord(val range: Interval, val constant: Option[BigInt])

/** Operation on words, before they have addresses. */
case class RayOperation(op: Int, to: RayWord, a: RayWord, b: RayWord)

/** Collects the operations that make a frame's coefficients, with the range of every word by interval arithmetic. What
  * is constant is folded, and nothing is computed twice.
  */
class RayProgramBuilder {
  val frame = ArrayBuffer[RayOperation]()
  val row = ArrayBuffer[RayOperation]()
  private val constants = LinkedHashMap[BigInt, RayWord]()
  private val known = HashMap[(Int, RayWord, RayWord), RayWord]()

  def constant(v: BigInt): RayWord = constants.getOrElseUpdate(v, new RayWord(Interval(v), Some(v)))

  private def step(op: Int, range: Interval, a: RayWord, b: RayWord): RayWord =
    known.getOrElseUpdate(
      (op, a, b), {
        val to = new RayWord(range, None)
        frame += RayOperation(op, to, a, b)
        if (op != RayStep.Subtract) known((op, b, a)) = to
        to
      }
    )
  private def is(w: RayWord, v: Int) = w.constant.contains(BigInt(v))

  def add(a: RayWord, b: RayWord): RayWord = (a.constant, b.constant) match {
    case (Some(x), Some(y)) => constant(x + y)
    case _ if is(a, 0)      => b
    case _ if is(b, 0)      => a
    case _                  => step(RayStep.Add, a.range + b.range, a, b)
  }

  def subtract(a: RayWord, b: RayWord): RayWord = (a.constant, b.constant) match {
    case (Some(x), Some(y)) => constant(x - y)
    case _ if is(b, 0)      => a
    case _ if a eq b        => constant(0)
    case _                  => step(RayStep.Subtract, a.range - b.range, a, b)
  }

  def multiply(a: RayWord, b: RayWord): RayWord = (a.constant, b.constant) match {
    case (Some(x), Some(y))        => constant(x * y)
    case _ if is(a, 0) || is(b, 0) => constant(0)
    case _ if is(a, 1)             => b
    case _ if is(b, 1)             => a
    // A step takes time by its second operand's width.
    case _ if a.range.width < b.range.width => multiply(b, a)
    case _ => step(RayStep.Multiply, if (a eq b) a.range.square else a.range * b.range, a, b)
  }

  /** Puts `from` into the state word `to` at the start of each frame. */
  def copy(to: RayWord, from: RayWord): Unit = frame += RayOperation(RayStep.Add, to, from, constant(0))

  /** Adds `by` to the state word `to` after each row. */
  def advance(to: RayWord, by: RayWord): Unit =
    if (!is(by, 0)) row += RayOperation(RayStep.Add, to, to, by)
}
