package frustum.engine.raster

import frustum.contract.video.Panel
import frustum.driver.raster.PreparedFrame

/** A frame as an engine drew it.
  *
  * @param image        RGB565, row by row from the top left
  * @param clocks       core clocks of the frame, store loaded, sink always ready
  * @param clocksAtPins core clocks from the first command bit to the last display bit
  * @param busBytes     bytes of the frame's commands on the wire, textures not included
  * @param setUps       triangles set up whole, @param moves triangles moved to a tile; a triangle counts in every pass
  */
final case class RenderedFrame(
    image: Array[Int],
    clocks: Option[Long] = None,
    clocksAtPins: Option[Long] = None,
    busBytes: Option[Long] = None,
    setUps: Option[Long] = None,
    moves: Option[Long] = None
)

/** Something that draws prepared frames: float64, bit-exact model, or simulated hardware. All frames of one
  * call have the same configuration and textures, so an engine may build and load once.
  */
trait Engine {
  def render(frames: Seq[PreparedFrame]): Seq[RenderedFrame]
}

/** What an engine may be told.
  *
  * @param seed of whatever is random, such as stalls
  * @param wave file that takes the waveform of a simulated engine
  * @param panel display at the pins
  */
final case class EngineOptions(seed: Long, wave: Option[java.nio.file.Path], panel: Panel = Panel.Ili9341)
