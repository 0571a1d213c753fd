package frustum.spec

import scala.collection.mutable.{ArrayBuffer, LinkedHashMap}

/** One step of the set-up: word `to` becomes a * b, a + b or a - b of words. */
case class RayStep(op: Int, to: Int, a: Int, b: Int)

object RayStep {
  val Multiply = 0
  val Add      = 1
  val Subtract = 2
}

/** Word of the set-up's memory, or a constant that needs none yet. */
class RayWord(val range: Interval, val constant: Option[BigInt], var address: Int = -1)

/** Collects the steps that make a frame's coefficients, folding what is constant, with the range of every word
  * by interval arithmetic.
  */
class RayProgramBuilder {
  val words             = ArrayBuffer[RayWord]()
  val frame             = ArrayBuffer[RayStep]()
  val row               = ArrayBuffer[RayStep]()
  private val constants = LinkedHashMap[BigInt, RayWord]()

  def constant(v: BigInt): RayWord = constants.getOrElseUpdate(v, new RayWord(Interval(v), Some(v)))

  def word(range: Interval): RayWord = {
    val w = new RayWord(range, None, words.size)
    words += w
    w
  }

  def address(w: RayWord): Int = {
    if (w.address < 0) { w.address = words.size; words += w }
    w.address
  }

  private def step(op: Int, range: Interval, a: RayWord, b: RayWord): RayWord = {
    val to = word(range)
    frame += RayStep(op, to.address, address(a), address(b))
    to
  }
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
    case _                  => step(RayStep.Subtract, a.range - b.range, a, b)
  }

  def multiply(a: RayWord, b: RayWord): RayWord = (a.constant, b.constant) match {
    case (Some(x), Some(y))        => constant(x * y)
    case _ if is(a, 0) || is(b, 0) => constant(0)
    case _ if is(a, 1)             => b
    case _ if is(b, 1)             => a
    case _ => step(RayStep.Multiply, if (a eq b) a.range.square else a.range * b.range, a, b)
  }

  /** Puts `from` into the state word `to` at the start of each frame. */
  def copy(to: RayWord, from: RayWord): Unit =
    frame += RayStep(RayStep.Add, to.address, address(from), address(constant(0)))

  /** Adds `by` to the state word `to` after each row. */
  def advance(to: RayWord, by: RayWord): Unit =
    if (!is(by, 0)) row += RayStep(RayStep.Add, to.address, to.address, address(by))
}
