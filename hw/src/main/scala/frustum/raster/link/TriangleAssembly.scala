package frustum.raster.link

import frustum.contract.raster.{RasterConfig, StoredVertex}
import frustum.raster.store.FieldBits._
import spinal.core._

/** The part of [[TriangleCommand]] that checks a triangle: it requests the corners' positions and tags, last corner
  * first, horizontally (position and tag) and then vertically (position alone), and computes the bounding box.
  *
  * @param tag     of the frame
  * @param index   of the vertex being read
  * @param corners word of the store that was read
  * @param arrives a read is answered in this cycle
  */
class TriangleAssembly(config: RasterConfig, tag: Bits, index: UInt, corners: Bits, arrives: Bool) extends Area {
  val tagRead = Reg(Bool()) // the word being read is that with the tag
  val vertical = Reg(Bool())
  val corner = Reg(UInt(2 bits))
  val stale = Reg(Bool()) // a corner was not sent in this frame
  val missed = Reg(Bool()) // the triangle is beside the screen horizontally
  val firstX, lastX = Reg(UInt(5 bits))

  private val bits = config.ranges.positionBits
  val box = TriangleBox(config)
  box.io.clear := False
  box.io.vertical := vertical
  box.io.coordinate.valid := arrives && !tagRead
  box.io.coordinate.payload := Mux(vertical, StoredVertex.Y.in(corners), StoredVertex.X.in(corners)).resize(bits).asSInt

  val cornerDone = tagRead || vertical // this answer is the last one of a corner
  val lastCorner = corner === 2

  /** Which of the corner's words is to be read. */
  val word = Mux(tagRead, U(StoredVertex.Tag.slice.word, 3 bits), U(StoredVertex.X.slice.word, 3 bits))
  val nothing = missed || box.io.empty // no pixel centre is on the screen

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
    when(tagRead && StoredVertex.Tag.in(corners) =/= tag)(stale := True)
    if (config.maxVertices < 1024) stale setWhen (index >= config.maxVertices)
  }

  /** Waits for the box; true in the last cycle. */
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
