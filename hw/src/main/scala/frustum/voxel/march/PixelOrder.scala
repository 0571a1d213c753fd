package frustum.voxel.march

import spinal.core._
import spinal.lib._

/** A finished pixel, RGB565, with its number modulo 512. */
case class OrderedPixel() extends Bundle {
  val color = Bits(16 bits)
  val tag = UInt(PixelOrder.TagBits bits)
}

/** Brings pixels into the order of their numbers: 256 of them in block RAM, each with the parity of the round in which
  * it was written.
  */
case class PixelOrder() extends Component {
  import PixelOrder._
  val io = new Bundle {
    val next = in UInt (TagBits bits) // number of the next pixel that will be begun
    val room = out Bool () // there is a place for pixel `next`
    val up = slave(Flow(OrderedPixel()))
    val down = master(Stream(Bits(16 bits)))
  }
  private val addressBits = TagBits - 1
  val words = Mem(Bits(17 bits), 1 << addressBits)

  /** After a reset all are made to look as in the round before. */
  val cleared = Reg(UInt(addressBits + 1 bits)) init 0
  val clears = !cleared.msb
  when(clears)(cleared := cleared + 1)
  val written = new Area {
    val valid = clears || io.up.valid
    val address = Mux(clears, cleared.resize(addressBits), io.up.tag.resize(addressBits))
    words.write(address, Mux(clears, True, io.up.tag.msb) ## io.up.color, valid)
  }

  val sent = RegInit(U(0, TagBits bits))
  val at = Mux(io.down.fire, sent + 1, sent)
  sent := at
  val word = words.readSync(at.resize(addressBits))
  val sure = RegNext(
    !(written.valid && written.address === at.resize(addressBits)),
    False
  ) // not read while it was written
  io.room := !clears && (io.next - sent) < (1 << addressBits)
  io.down.valid := sure && word.msb === sent.msb
  io.down.payload := word(15 downto 0)
}

object PixelOrder {
  val TagBits = 9
}
