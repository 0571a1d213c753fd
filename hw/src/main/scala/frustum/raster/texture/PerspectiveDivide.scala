package frustum.raster.texture

import frustum.arithmetic.{LockstepPipeline, Multiplier16}
import frustum.contract.arithmetic.ReciprocalTable
import frustum.device.Tech
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Texture coordinates s/q and t/q of one fragment per cycle, latency 7 cycles, 5 multipliers, 2 tables of 256 x 16.
  *
  *   1. q is normalised: q 2^e has bit 30 set, e = 0..15 (a smaller q gives a wrong coordinate, nothing
  *      worse); qn = q 2^e / 2^31 = (1 + f) / 2
  *   1. r = 2 f / (1 + f) from [[frustum.contract.arithmetic.ReciprocalTable]], 16 fraction bits, so 1 / qn = 2 - r
  *   1. s is shifted by the same e: sn, 22 fraction bits; result 2 sn - sn r, the multipliers subtracting, of which the
  *      lower one takes the complement: low by at most 2^-22; cut to 17 fraction bits. The lower four bits of sn are
  *      replaced by ones: they need no shifting, a power of two as q stays exact, and the error of cutting is on both
  *      sides of zero
  *
  * Widths: |s / q| <= 256 and qn < 1, so |sn| < 256 fits s8.22, and |sn (2 - r)| <= 2 |sn| < 512 fits s9.22
  * whatever the input, so nothing wraps after the shift. Error: relative 2^-16 from r, and 2^-17 repeats from
  * cutting.
  */
case class PerspectiveDivide(tech: Tech = Tech.Generic) extends Component {
  val io = DivideIo()
  val line = new LockstepPipeline(7)
  val enable = line.enable

  val Q = Payload(Bits(25 bits)) // bits 30..6 after the coarse shift
  val FINE = Payload(UInt(2 bits))
  val FOUR = Payload(Bool())
  val INDEX = Payload(UInt(ReciprocalTable.IndexBits bits))
  val FRACTION = Payload(Bits(ReciprocalTable.FractionBits bits))

  line(0).driveFrom(io.up)((_, _) => ())
  val coarse = new Area {
    val q = io.up.q(30 downto 0).asBits
    val zero = Vec((0 until 3).map(i => q(30 - 4 * i downto 27 - 4 * i) === 0))
    val by8 = zero(0) && zero(1)
    val by4 = zero(0) && (!zero(1) || zero(2))
    val shifted = Vec(Seq(0, 4, 8, 12).map(n => (q << n)(30 downto 6)))(U(by8 ## by4))
  }
  line(0)(Q) := coarse.shifted
  line(0)(FOUR) := coarse.by4

  val fine = new Area {
    val q = line(1)(Q)
    val steps = UInt(2 bits)
    steps := 3
    when(q(22)) { steps := 2 }
    when(q(23)) { steps := 1 }
    when(q(24)) { steps := 0 }
    val f = Vec((0 to 3).map(n => (q << n)(23 downto 4)))(steps)
  }
  line(1)(FINE) := fine.steps
  line(1)(INDEX) := fine.f(19 downto 12).asUInt
  line(1)(FRACTION) := fine.f(11 downto 0)

  val slopes = Mem(Bits(16 bits), ReciprocalTable.slopeWords.map(B(_, 16 bits)))
  val bases = Mem(Bits(16 bits), ReciprocalTable.baseWords.map(B(_, 16 bits)))

  val slopeWord = slopes.readSync(line(1)(INDEX), enable) // at node 2
  val baseWord = bases.readSync(line(1)(INDEX), enable)
  val correction = Multiplier16(tech, signedA = false, signedB = false, add = true)
  correction.io.enable := enable
  correction.io.a := slopeWord(12 downto 0).resized
  correction.io.b := line(2)(FRACTION).resized
  correction.io.addend := baseWord ## slopeWord(15 downto 13) ## B(0, 13 bits)
  val r = correction.io.product(31 downto 16) // at node 4

  val quotients = Seq(io.up.s, io.up.t).map(new Quotient(_))

  line.nodes.last.driveTo(io.down) { (payload, _) =>
    payload.s := quotients(0).result
    payload.t := quotients(1).result
  }
  io.busy := line.anyValid
  line.build()

  /** One coordinate: shifted one binary step per node while the reciprocal is computed, then multiplied by 2 - r. */
  class Quotient(raw: SInt) extends Area {
    val BY8, BY4, BY2 = Payload(SInt(32 bits))
    val SN = Payload(SInt(31 bits)) // the lower four bits count as ones, which centres the error of cutting
    val RESULT = Payload(SInt(TextureCoordinate.Width bits))

    line(0)(BY8) := Mux(coarse.by8, raw |<< 8, raw)
    line(1)(BY4) := Mux(line(1)(FOUR), line(1)(BY8) |<< 4, line(1)(BY8))
    line(2)(BY2) := Mux(line(2)(FINE)(1), line(2)(BY4) |<< 2, line(2)(BY4))
    line(3)(SN) := (Mux(line(3)(FINE)(0), line(3)(BY2) |<< 1, line(3)(BY2)) >> 1) | 15

    val high = Multiplier16(tech, signedA = true, signedB = false, add = true, subtract = true)
    val low = Multiplier16(tech, signedA = false, signedB = false, add = true, subtract = true)
    for (m <- Seq(high, low)) { m.io.enable := enable; m.io.b := r }
    high.io.a := line(4)(SN)(30 downto 16).resize(16).asBits
    high.io.addend := (line(4)(SN) << 1).asBits
    low.io.a := line(4)(SN)(15 downto 0).asBits
    low.io.addend := B(32 bits, default -> True) // -1, so the product is the complement, its sign beyond the word
    line(6)(RESULT) := (high.io.product.asSInt + (B"xFFFF" ## low.io.product(31 downto 16)).asSInt)
      .drop(5)
      .asSInt
    def result: SInt = line(7)(RESULT)
  }
}
