package frustum.video

import frustum.contract.video.{Panel, ScreenTiles}
import frustum.device.Tech
import spinal.core._
import spinal.lib._

/** Finished tiles to an ILI9341 or ST7789.
  *
  * After reset: the panel's reset pin low, a pause, the panel's commands with a pause after "sleep out"; a pause lasts
  * at least [[frustum.contract.video.Panel.SettleMs]], at most twice that. Then each tile is a window write (column and
  * row address, memory write) and its pixels, RGB565, high byte first, without gaps while pixels come in time, one per
  * `16 * clocksPerBit` cycles; 11 bytes per window.
  *
  * A panel without chip select is sent to in SPI mode 3, SCK resting high, which needs at least 2 cycles per bit. It
  * counts bits from its reset on; `cs` is not connected there.
  *
  * @param clockHz      the clock's frequency
  * @param clocksPerBit a power of two: SCK is the clock divided by it
  * @param tech         used with one cycle per bit only
  * @param fast         shortens the pauses by this factor, for simulation
  */
case class SpiDisplay(
    config: ScreenTiles,
    panel: Panel,
    clockHz: Long,
    clocksPerBit: Int = 2,
    fast: Int = 1,
    tech: Tech = Tech.Generic
) extends Component {
  val io = new Bundle {
    val pixels = slave(Stream(ResolvedPixel(config)))
    val pins = master(DisplayPins())
  }
  import DisplayState._

  val shifter = ByteShifter(clocksPerBit, tech, restHigh = !panel.selectPin)
  io.pins.sck := shifter.io.sck
  io.pins.mosi := shifter.io.mosi
  io.pins.dc := shifter.io.dc
  io.pins.cs := shifter.io.cs

  val state = RegInit(resetting)
  val windowed = RegInit(False) // the window of the current tile is set
  val index = RegInit(U(0, 4 bits))
  val pause = RegInit(U(0, SpiDisplay.pauseBits(clockHz, fast) bits))
  io.pins.reset := RegNext(state =/= resetting) init False

  val start = panel.start(config).flatMap(c => (false, c.code) +: c.parameters.map((true, _)))
  require(start.size <= 16, s"${panel.name}: ${start.size} bytes of initialisation, at most 16")
  val startBytes = Vec(start.padTo(16, start.last).map { case (data, value) =>
    B(value | (if (data) 256 else 0), 9 bits)
  })
  val startByte = startBytes(index)

  /** First and last pixel of a tile along an axis, the last one clipped to the screen, which begins at `origin`. */
  def ends(tile: UInt, log2: Int, pixels: Int, origin: Int): (UInt, UInt) = {
    val first = (tile << log2).resize(16)
    val last = (tile @@ U((1 << log2) - 1, log2 bits)).resize(16)
    val whole = pixels % (1 << log2) == 0
    def moved(v: UInt): UInt = if (origin == 0) v else v + origin
    (moved(first), moved(if (whole) last else Mux(tile === pixels >> log2, U(pixels - 1, 16 bits), last)))
  }
  val (column, row) = panel.origin(config)
  val (x0, x1) = ends(io.pixels.tileX, config.tileLog2Width, config.width, column)
  val (y0, y1) = ends(io.pixels.tileY, config.tileLog2Height, config.height, row)
  def bytesOf(v: UInt): Seq[Bits] = Seq(v(15 downto 8).asBits, v(7 downto 0).asBits)
  val columns = Seq(B(Panel.ColumnAddress, 8 bits)) ++ bytesOf(x0) ++ bytesOf(x1)
  val rows = Seq(B(Panel.RowAddress, 8 bits)) ++ bytesOf(y0) ++ bytesOf(y1)
  val write = B(Panel.MemoryWrite, 8 bits)
  val windowByte = Vec((columns ++ rows :+ write).padTo(16, write))(index)
  val isCommand = index === 0 || index === columns.size || index === columns.size + rows.size

  val needWindow = io.pixels.first && !windowed
  val bytes = shifter.io.bytes
  bytes.valid := False
  bytes.data := True
  bytes.value := io.pixels.color(7 downto 0)
  io.pixels.ready := False
  val paused = RegNext(pause.andR, False)

  switch(state) {
    is(resetting) {
      pause := pause + 1
      when(paused) { pause := 0; state := settling }
    }
    is(settling) {
      pause := pause + 1
      when(paused) { pause := 0; state := starting }
    }
    is(starting) {
      bytes.valid := True
      bytes.data := startByte.msb
      bytes.value := startByte(7 downto 0)
      when(bytes.ready) {
        index := index + 1
        when(index === 0)(state := settling)
        when(index === start.size - 1) { index := 0; state := pixel }
      }
    }
    is(window) {
      bytes.valid := True
      bytes.data := !isCommand
      bytes.value := windowByte
      when(bytes.ready) {
        index := index + 1
        when(index === columns.size + rows.size) { index := 0; windowed := True; state := high }
      }
    }
    is(pixel)(when(io.pixels.valid)(state := Mux(needWindow, window(), high())))
    is(high) {
      bytes.valid := True
      bytes.value := io.pixels.color(15 downto 8)
      when(bytes.ready)(state := low)
    }
    is(low) {
      bytes.valid := True
      io.pixels.ready := bytes.ready
      when(bytes.ready) { windowed := False; state := pixel }
    }
  }
}

object DisplayState extends SpinalEnum {
  val resetting, settling, starting, pixel, window, high, low = newElement()
}

object SpiDisplay {

  /** A pause has 2^n cycles. */
  def pauseBits(clockHz: Long, fast: Int): Int = {
    require(clockHz > 0 && fast >= 1, s"SpiDisplay: clock of $clockHz Hz, pauses shortened by $fast: both at least 1")
    log2Up((BigInt(clockHz) * Panel.SettleMs / 1000 / fast).max(16))
  }
}
