package frustum.video

import spinal.core._
import spinal.lib._

/** A pixel for a frame buffer: row by row from the top left. */
case class FramePixel(pixels: Int, bits: Int) extends Bundle {
  val address = UInt(log2Up(pixels) bits)
  val color = Bits(bits bits)
}

/** Two pictures: one is written while the other is read, and `swap` exchanges them in the next cycle. A read takes
  * three cycles.
  */
case class DoubleFrameBuffer(pixels: Int, bits: Int) extends Component {
  val io = new Bundle {
    val write = slave(Flow(FramePixel(pixels, bits)))
    val address = in UInt (log2Up(pixels) bits)
    val color = out Bits (bits bits)
    val swap = in Bool ()
  }
  val front = RegInit(False) toggleWhen io.swap
  val memory = Mem(Bits(bits bits), 2 * pixels)
  private def place(upper: Bool, address: UInt) =
    Mux(upper, address.resize(log2Up(2 * pixels)) + pixels, address.resize(log2Up(2 * pixels)))

  // Registers around the memory, because it is spread over the device.
  val written = RegNext(io.write.valid) init False
  memory.write(RegNext(place(!front, io.write.address)), RegNext(io.write.color), written)
  io.color := RegNext(memory.readSync(RegNext(place(front, io.address))))
}
