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

  /** It is not yet where the row's first pixel inside is. */
  def wants: Bool = inside ? canLeave | canEnter

  /** No pixel of the row is inside, as far as the edge has moved. */
  def cutsAll: Bool = !inside && !back

  /** Takes the function's value, 1/256 pixel^2, at the outermost pixel; until it is primed, it stays there. */
  def load(edge: SInt): Unit = {
    value := (~edge >> 4).resized
    tie := edge(3 downto 0) === 0
    canEnter := False
    canLeave := False
  }
}

/** What becomes of an edge in a cycle: one adder and the rules by which it is used.
  *
  * An edge slides inwards while its value is outside. Once it is inside and later rows can only move it outwards, it
  * tests the pixel outside of its own, and slides outwards while that is inside. So each cycle moves it by a pixel,
  * save the first test. Both ends of the row stop it.
  *
  * @param slides  it moves along the row
  * @param shrinks with `slides`: see [[EdgeMove.shrinks]]; else it moves to the row below
  * @param primes  with neither, a loaded value becomes one to walk with: an exact zero is outside unless the edge owns
  *                its points (top-left rule; Pineda 1988)
  */
final class EdgeMove(state: EdgeState, steps: EdgeSteps, slides: Bool, shrinks: Bool, primes: Bool) extends Area {
  private val adds = slides || shrinks
  private val step = slides ? steps.slope | steps.descent
  private val addend = (step ^ S(step.bitsRange -> shrinks)) & S(step.bitsRange -> adds)
  private val carry = adds ? shrinks | (primes && state.tie && !steps.topLeft)
  private val inwards = slides && !state.inside
  private val outwards = slides && state.inside && state.back
  private val most = (1 << state.cut.getWidth) - 1

  /** The edge after that. */
  def moved(into: EdgeState): Unit = {
    into.value := ((state.value @@ True).asBits.asSInt + (addend @@ carry).resize(state.value.getWidth + 1)) >> 1
    into.cut := ((state.cut @@ True) + (U(state.cut.bitsRange -> outwards) @@ inwards)) >> 1
    when(slides) {
      into.back := state.inside
      into.canEnter := !state.inside && state.cut =/= most - 1
      into.canLeave := state.inside ? !(state.back && state.cut === 1) | steps.grows
    } otherwise {
      into.back := state.back
      into.canEnter := state.canEnter
      into.canLeave := state.canLeave
    }
    when(primes) {
      into.cut := 0
      into.back := False
      into.canEnter := !steps.flat
      into.canLeave := False
    }
  }
}

object EdgeMove {

  /** Whether an edge's complement shrinks by the slope, rather than grows, as it slides: on the way in from the left
    * and on the way out from the right.
    */
  def shrinks(state: EdgeState, steps: EdgeSteps): Bool = state.inside === steps.fromRight
}
