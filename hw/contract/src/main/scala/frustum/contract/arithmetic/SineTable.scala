package frustum.contract.arithmetic

import java.lang.Math.floorMod
import scala.math.{Pi, round, sin}

/** Sines of 1/1024 turns, 16 fraction bits, rounded: a quarter of a turn is stored. */
object SineTable {

  /** Bits of an angle: 1/1024 turn. */
  val AngleBits = 10
  val Turn: Int = 1 << AngleBits
  val FractionBits = 16
  val IndexBits = AngleBits - 2

  /** With the sign and the integer bit of 1. */
  val Width = FractionBits + 2

  /** Of i / 1024 turn. The first one that is not stored is 1. */
  val quarter: IndexedSeq[Int] =
    IndexedSeq.tabulate(1 << IndexBits)(i => round((1 << FractionBits) * sin(Pi / 2 * i / (1 << IndexBits))).toInt)

  def sine(angle: Int): Int = {
    val a = floorMod(angle, Turn)
    val within = a & (1 << IndexBits) - 1
    val size =
      if ((a >> IndexBits & 1) == 0) quarter(within)
      else if (within == 0) 1 << FractionBits
      else quarter((1 << IndexBits) - within)
    if (a >> IndexBits + 1 == 0) size else -size
  }

  /** Rounded to 8 fraction bits. */
  def coarse(angle: Int): Int = (sine(angle) + (1 << FractionBits - 9)) >> FractionBits - 8
}
