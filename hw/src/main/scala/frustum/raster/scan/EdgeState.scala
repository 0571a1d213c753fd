package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import spinal.core._

/** What an edge function changes by, and what is known of that. */
case class EdgeSteps(config: RasterConfig) extends Bundle {
  val slope, descent = SInt(config.ranges.stepBits bits) // per pixel to the right, per row
  val flat = Bool() // the slope is 0
  val grows = Bool() // the descent is above 0: the edge lets more of each row through than of the one before

  /** Whether the edge cuts off the right end of a row rather than the left one. */
  def fromRight: Bool = slope.msb

  /** Whether the edge owns its points. */
  def topLeft: Bool = !fromRight && (!flat || grows)
}

/** An edge at a pixel of a row.
  *
  * The edge function is held as its complement, without the sixteenths that are the same at all pixel centres: it is
  * inside where this is negative. So a zero can be made to count as outside by a carry.
  */
case class EdgeState(config: RasterConfig) extends Bundle {
  val value = SInt(config.ranges.edgeBits bits)
  val cut = UInt(config.tileLog2Width bits) // pixels cut off, on the edge's side of the row
  val back = Bool() // the value is that of the last pixel cut off, not of the first one left; not yet primed: see `tie`
  val canEnter = Bool() // the edge moves inwards when it is outside
  val canLeave = Bool() // the edge moves outwards when it is inside

  /** Whether the sixteenths are 0, in an edge that is not yet primed. */
  def tie: Bool = back

  def inside: Bool = value.msb

  /** No pixel of the row is inside, as far as the edge has moved. */
  def cutsAll: Bool = !inside && !back

  /** Takes the function's value, 1/256 pixel^2, at the outermost pixel; to be primed. */
  def load(edge: SInt): Unit = {
    value := (~edge >> 4).resized
    tie := edge(3 downto 0) === 0
  }
}

/** What becomes of an edge in a cycle: one adder and the rules by which it is used.
  *
  * An edge moves inwards while its value is outside. Once it is inside and later rows can only move it outwards, it
  * tests the pixel outside of its own, and moves outwards while that is inside. So each cycle moves it by a pixel, save
  * the first test. Both ends of the row stop it.
  *
  * @param slides whether it moves along the row, else to the row below
  * @param prime  makes a loaded value one to walk with, in place of a move down: an exact zero is outside unless the
  *               edge owns its points (top-left rule; Pineda 1988)
  */
final class EdgeMove(state: EdgeState, steps: EdgeSteps, slides: Bool, prime: Bool) extends Area {
  private val width = state.value.getWidth

  // The complement grows by the slope on the way out from the left and on the way in from the right; else it shrinks.
  private val shrinks = slides ? (state.inside === steps.fromRight) | !prime
  private val step = slides ? steps.slope | steps.descent
  private val adds = slides || shrinks
  private val addend = (step ^ S(step.range -> shrinks)) & S(step.range -> adds)
  private val carry = adds ? shrinks | (state.tie && !steps.topLeft)

  /** The value after the move. */
  val value: SInt = ((state.value @@ True).asBits.asSInt + (addend @@ carry).resize(width + 1)) >> 1

  private val outwards = state.inside && state.back
  private val cut =
    ((state.cut @@ True) + (U(state.cut.range -> state.inside) @@ !outwards)) >> 1

  /** The edge after a move along the row, with [[value]] in it. */
  def slid(into: EdgeState): Unit = {
    into.value := value
    into.cut := cut
    into.back := state.inside
    into.canEnter := !state.inside && !cut.andR
    into.canLeave := state.inside ? cut.orR | steps.grows
  }

  /** The edge after a move down, or after it is primed. */
  def descended(into: EdgeState): Unit = {
    into.value := value
    into.cut := prime ? U(0, state.cut.getWidth bits) | state.cut
    into.back := !prime && state.back
    into.canEnter := prime ? !steps.flat | state.canEnter
    into.canLeave := !prime && state.canLeave
  }
}
