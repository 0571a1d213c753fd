package frustum.raster.texture

import spinal.core._

/** A decoded texel: the bits that reach the frame buffer, and five bits of alpha. */
case class Texel() extends Bundle {
  val r = UInt(5 bits)
  val g = UInt(6 bits)
  val b = UInt(5 bits)
  val a = UInt(5 bits)
}

object Texel {

  /** RGB565 with full alpha, or RGBA4444 widened by repeating each channel's upper bits. */
  def decode(word: Bits, rgba4444: Bool): Texel = {
    val texel = Texel()
    def widened(nibble: Bits, bits: Int) = (nibble ## nibble.takeHigh(bits - 4)).asUInt
    texel.r := Mux(rgba4444, widened(word(15 downto 12), 5), word(15 downto 11).asUInt)
    texel.g := Mux(rgba4444, widened(word(11 downto 8), 6), word(10 downto 5).asUInt)
    texel.b := Mux(rgba4444, widened(word(7 downto 4), 5), word(4 downto 0).asUInt)
    texel.a := Mux(rgba4444, widened(word(3 downto 0), 5), U(31, 5 bits))
    texel
  }
}
