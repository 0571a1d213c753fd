package frustum.raster.link

import frustum.contract.raster.RasterConfig
import spinal.core._
import spinal.lib._

/** The tiles a triangle may touch along one axis, from its three coordinates, one after the other.
  *
  * Pixel i can be covered only if its centre 16 i + 8 is within the coordinates' range. With p = floor(c / 16), the
  * first such pixel for a least coordinate c is p, or p + 1 where c is beyond p's centre; the range ends before the
  * same pixel for a greatest coordinate, one later where c is on the centre. Both ends are clipped to the screen.
  *
  * Results are right five cycles after the last coordinate, at most one coordinate per cycle.
  */
case class TriangleBox(config: RasterConfig) extends Component {
  val pixelBits = log2Up(config.width.max(config.height) + 1)
  val io = new Bundle {
    val clear = in Bool ()
    val vertical = in Bool () // the axis, constant from `clear` on
    val coordinate = slave(Flow(SInt(config.ranges.positionBits bits))) // 1/16 pixel
    val firstX, lastX, firstY, lastY = out UInt (5 bits) // of the current axis; the other pair is undefined
    val empty = out Bool () // no pixel centre on the screen
  }

  val limit = Mux(io.vertical, U(config.height, pixelBits bits), U(config.width, pixelBits bits))

  val taken = RegNext(io.coordinate.valid) init False
  val coordinate = RegNextWhen(io.coordinate.payload, io.coordinate.valid)
  val pixel = coordinate(config.ranges.positionBits - 2 downto 4).asUInt
  val fraction = coordinate(3 downto 0).asUInt
  val left = coordinate.sign
  val right = pixel >= limit

  // A coordinate's pixel and whether it is on its centre; between coordinates, the least one's and true.
  val clipped = RegNext(taken) init False
  val position = Reg(UInt(pixelBits bits))
  val onCentre = Reg(Bool())
  val least = Reg(UInt(pixelBits bits))
  val greatest = Reg(UInt(pixelBits + 1 bits)) // the greatest coordinate's pixel, and whether it is on the centre
  position := (pixel +^ (fraction > 8).asUInt).resize(pixelBits)
  onCentre := fraction === 8 && !left && !right
  when(right)(position := limit)
  when(left)(position := 0)
  when(!taken) {
    position := least
    onCentre := True
  }

  val beyond = (position @@ onCentre.asUInt) > greatest
  when(clipped && position < least)(least := position)
  when(clipped && beyond)(greatest := position @@ onCentre.asUInt)
  when(io.clear) {
    least.setAll()
    greatest.clearAll()
  }

  val last = (greatest - 1) >> 1
  io.empty := RegNext(beyond)
  io.firstX := (least >> config.tileLog2Width).resized
  io.lastX := (last >> config.tileLog2Width).resized
  io.firstY := (least >> config.tileLog2Height).resized
  io.lastY := (last >> config.tileLog2Height).resized
}
