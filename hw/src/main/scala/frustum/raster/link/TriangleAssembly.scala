package frustum.raster.link

import frustum.contract.raster.RasterConfig
import spinal.core._

/** The part of [[CommandDecoder]] that judges a triangle: it has the corners' positions and tags read, last corner
  * first, horizontally (position and tag) and then vertically (position alone), and finds the bounding box.
  *
  * @param tag     of the frame
  * @param index   of the vertex being read
  * @param corners word of the store that a read has brought
  * @param arrives a read is answered in this clock
  */
class TriangleAssembly(config: RasterConfig, tag: Bits, index: UInt, corners: Bits, arrives: Bool) extends Area {
  val arrived = Reg(UInt(CommandDecoder.CountBits bits)) // since begin
  val stored = Reg(UInt(config.countBits bits)) // in the bank
  val renderState = Reg(Bits(4 bits))

  val tagRead = Reg(Bool()) // the word being read is that with the tag
  val vertical = Reg(Bool())
  val corner = Reg(UInt(2 bits))
  val stale = Reg(Bool()) // a corner was not sent in this frame
  val missed = Reg(Bool()) // the screen, horizontally
  val firstX, lastX = Reg(UInt(5 bits))

  private val bits = config.ranges.positionBits
  val box = TriangleBox(config)
  box.io.clear := False
  box.io.vertical := vertical
  box.io.coordinate.valid := arrives && !tagRead
  box.io.coordinate.payload := Mux(vertical, corners(0, bits bits), corners(16, bits bits)).asSInt

  val cornerDone = tagRead || vertical // with this answer
  val lastCorner = corner === 2

  val nothing = missed || box.io.empty
  val full = RegNext(stored === config.maxTriangles)
  val refused = stale || (!nothing && full)

  /** The box as the lower bits of the triangle's second word hold it. */
  val boxBits = firstX ## lastX ## box.io.firstY ## box.io.lastY

  def start(): Unit = {
    tagRead := False
    vertical := False
    corner := 0
    stale := False
    box.io.clear := True
  }

  def answer(): Unit = {
    tagRead := !vertical && !tagRead
    when(cornerDone)(corner := corner + 1)
    when(tagRead && corners(31 downto 25) =/= tag)(stale := True)
    if (config.maxVertices < 1024) stale setWhen (index >= config.maxVertices)
  }

  /** Waits for the box; true in the last clock. */
  def settle(): Bool = {
    corner := corner + 1 // 3, 0, 1, 2
    corner === 2
  }

  def turnVertical(): Unit = {
    corner := 0
    vertical := True
    missed := box.io.empty
    firstX := box.io.firstX
    lastX := box.io.lastX
    box.io.clear := True
  }
}
