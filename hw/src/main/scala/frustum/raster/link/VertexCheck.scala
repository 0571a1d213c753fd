package frustum.raster.link

import frustum.contract.raster.VertexRanges
import spinal.core._
import spinal.lib._

/** Checks the ten words of a vertex as they pass for range, the same test as
  * [[frustum.contract.raster.PackedVertex.fault]]. `word` carries pairs of words; in the cycle after each, while
  * `busy`, `pair` is its pair, 0 to 4, and `second` is high for the later one of it. `fault` is right from the cycle
  * after that until `clear`; depth, exponent and colour cannot be out of range.
  */
case class VertexCheck(ranges: VertexRanges) extends Component {
  val io = new Bundle {
    val clear = in Bool ()
    val word = slave(Flow(Bits(16 bits)))
    val pair = in UInt (3 bits)
    val second = in Bool ()
    val busy = out(RegNext(word.valid) init False)
    val fault = out(RegInit(False))
  }
  private val word = io.word.payload

  // A field of n bits that may hold -2^(n-1) + 1 to 2^(n-1) - 1: its spare upper bits repeat the sign, and the most
  // negative value is refused, which for texture coordinates takes both words.
  private val magnitude = ranges.position + 4 // bits of the magnitude of x and y
  private val low = ranges.repeats // so many bits of a texture coordinate's upper word
  private def zeroes(high: Int, low: Int) = if (high < low) True else RegNext(word(high downto low) === 0)
  val lowZero = zeroes(low - 1, 0)
  val magZero = lowZero && zeroes(magnitude - 1, low)
  val upper = RegNext(word(15 downto magnitude))
  val signs = RegNext(word(10 downto ranges.repeats))
  val zero = magZero && !upper.orR
  val position = upper.orR && !upper.andR || (upper.msb && magZero)
  val texture = !signs.andR && signs.orR
  val lowest = RegNextWhen(signs.andR && lowZero, io.busy && !io.second)

  val bad = io.pair.mux(
    0 -> position,
    1 -> (io.second && !upper.msb), // mantissa not normalised
    2 -> Mux(io.second, lowest && zero, texture),
    3 -> Mux(io.second, lowest && zero, texture),
    default -> False
  )
  when(io.clear)(io.fault := False)
  when(io.busy && bad)(io.fault := True)
}
