package frustum.raster.texture

import frustum.arithmetic.{LockstepPipeline, Multiplier16}
import frustum.contract.arithmetic.ReciprocalTable
import frustum.contract.raster.{RasterConfig, SetupWords, VertexRanges}
import frustum.device.Tech
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Texture coordinates s/q and t/q as [[PerspectiveDivide]] makes them, for triangles whose depths are near each other
  * (`ratio` of [[frustum.contract.raster.VertexRanges]] `LateRatio` at most): one per cycle, latency 7, 5 multipliers,
  * 2 tables of 256 x 16.
  *
  * Since q is normalised by e = 0..ratio steps alone, s and t need not be shifted before the division: they are kept in
  * memories of 8 words until the reciprocal is there, and the quotient is shifted.
  *
  *   1. qn = q 2^e in 1/2..1 (a smaller q gives a wrong coordinate, nothing worse); 1 / qn = 2 - r, r of 16 fraction
  *      bits
  *   1. v = s without its lowest bits, which are zero, at most 30 bits; v (2^17 - r), exact, in two products one after
  *      the other, of v's lower 15 bits and of its upper ones; lowest 15 bits cut
  *   1. shifted by e; cut to 17 fraction bits. So half of v's last place, times 2^e, is what is lost
  */
case class LateDivide(config: RasterConfig, tech: Tech = Tech.Generic) extends Component {
  val io = DivideIo()
  val ratio = config.ranges.ratio
  val low = LateDivide.low(config)
  val line = new LockstepPipeline(7)
  val enable = line.enable
  val at = Reg(UInt(3 bits)) init 0
  when(enable)(at := at + 1)

  /** What was at a node is at the node that is `nodes` later. */
  def wait(data: Bits, nodes: Int): Bits = {
    val memory = Mem(Bits(widthOf(data) bits), 8)
    memory.addAttribute("ram_style", "block")
    memory.write(at, data, enable)
    memory.readSync(at - (nodes - 1), enable)
  }

  line(0).driveFrom(io.up)((_, _) => ())
  val FRACTION = Payload(Bits(ReciprocalTable.FractionBits bits))
  val q = io.up.q(30 downto 0).asBits
  val steps = UInt(log2Up(ratio + 1) bits)
  steps := ratio
  for (e <- ratio - 1 to 0 by -1) when(q(30 - e))(steps := e)
  val f =
    Vec((0 to ratio).map(e => (q |<< e)(29 downto 10)).padTo(1 << widthOf(steps), (q |<< ratio)(29 downto 10)))(steps)
  line(0)(FRACTION) := f(11 downto 0)

  val (slopeWord, baseWord) = LateDivide.tables(f(19 downto 12).asUInt, enable) // at node 1
  val correction = Multiplier16(tech, signedA = false, signedB = false, add = true)
  correction.io.enable := enable
  correction.io.a := slopeWord(12 downto 0).resized
  correction.io.b := line(1)(FRACTION).resized
  correction.io.addend := baseWord ## slopeWord(15 downto 13) ## B(0, 13 bits)
  val r = correction.io.product(31 downto 16) // at node 3
  val rLate = wait(r, 2)

  val values =
    Seq(io.up.s, io.up.t).map(raw => (raw >> low).resize(config.ranges.coordinateBits - low).resize(30).asBits)
  private val upperBits = (config.ranges.coordinateBits - low - 15).max(1)
  private val uppers = wait(steps ## values(1)(15, upperBits bits) ## values(0)(15, upperBits bits), 5)
  val STEPS = Payload(UInt(widthOf(steps) bits))
  line(5)(STEPS) := uppers.drop(2 * upperBits).asUInt

  val results = for ((value, n) <- values.zipWithIndex) yield {
    val lower = wait(value(14 downto 0), 3)
    val upper = uppers(n * upperBits, upperBits bits).asSInt.resize(15) // at node 5
    val first = Multiplier16(tech, signedA = false, signedB = false, add = true, subtract = true)
    val last = Multiplier16(tech, signedA = true, signedB = false, add = true, subtract = true)
    first.io.enable := enable
    first.io.a := lower.resized
    first.io.b := r
    first.io.addend := lower ## B(0, 17 bits)
    last.io.enable := enable
    last.io.a := upper.resize(16).asBits
    last.io.b := rLate
    last.io.addend := upper.asBits ## first.io.product(31 downto 15)
    val product = last.io.product.asSInt // at node 7, s / qn with 24 - low fraction bits
    val shifted = (0 to ratio).map(e => ((product << (low + e)) >> 7).resize(TextureCoordinate.Width))
    Vec(shifted.padTo(1 << widthOf(steps), shifted.last))(line(7)(STEPS))
  }
  line.nodes.last.driveTo(io.down) { (payload, _) =>
    payload.s := results(0)
    payload.t := results(1)
  }
  io.busy := line.anyValid
  line.build()
}

object LateDivide {

  /** Block RAM that it has and [[PerspectiveDivide]] has not. */
  val Memories = 4

  /** Whether a pipeline has it: depths are near each other, and the block RAM of planes that are not needed is free. */
  def suits(config: RasterConfig): Boolean =
    config.ranges.ratio <= VertexRanges.LateRatio && spare(config.fixed.planes) >= Memories

  /** Block RAM of 256 x 16 that a pipeline without some planes does not need: coefficients, two for depth and one for a
    * colour, depth's tile memories and its delay, and part of [[frustum.raster.fragment.AttributeMemory]], which holds
    * 9 bits beside the colours' 9 each.
    */
  private def spare(planes: Seq[Int]): Int = {
    val colors = planes.count(_ >= SetupWords.PlaneR)
    def words(bits: Int) = (bits + 15) / 16
    (if (planes.contains(SetupWords.PlaneZ)) 0 else 2 + 2 + 1) + 4 - colors + words(9 + 9 * 4) - words(9 + 9 * colors)
  }

  /** Lowest bits of s/w and t/w that are left out. */
  def low(config: RasterConfig): Int = config.formats.coordinate.max(config.ranges.coordinateBits - 30)

  /** Slope's and base's word for an index, a cycle later. */
  private def tables(index: UInt, enable: Bool): (Bits, Bits) = {
    val slopes = Mem(Bits(16 bits), ReciprocalTable.slopeWords.map(B(_, 16 bits)))
    val bases = Mem(Bits(16 bits), ReciprocalTable.baseWords.map(B(_, 16 bits)))
    (slopes.readSync(index, enable), bases.readSync(index, enable))
  }
}
