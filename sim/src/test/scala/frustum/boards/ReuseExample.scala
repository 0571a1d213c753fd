package frustum.boards

// docs/reuse.md quotes what follows.
import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.video.{DisplayPins, ResolvedPixel, SpiDisplay}

import spinal.core._
import spinal.lib._

/** A display that shows one colour, set by the rest of the SoC. */
case class ColorScreen(clockHz: Long) extends Component {
  val config = RasterConfig(width = 240, height = 240, tileLog2Width = 4, tileLog2Height = 4)
  val io = new Bundle {
    val color = in Bits (16 bits) // RGB565
    val display = master(DisplayPins())
  }

  // Tiles in any order, 16 x 16 pixels each: the display unit sets a window for each of them.
  val pixels = Stream(ResolvedPixel(config))
  val pixel = Counter(256, inc = pixels.fire)
  val tileX = Counter(config.tilesX, inc = pixel.willOverflow)
  val tileY = Counter(config.tilesY, inc = tileX.willOverflow)
  pixels.valid := True
  pixels.color := io.color
  pixels.first := pixel.value === 0
  pixels.tileX := tileX.value.resized
  pixels.tileY := tileY.value.resized

  val display = SpiDisplay(config, Panel.St7789, clockHz)
  display.io.pixels << pixels
  display.io.pins <> io.display
}
