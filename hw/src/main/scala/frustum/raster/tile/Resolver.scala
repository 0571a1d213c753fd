package frustum.raster.tile

import frustum.contract.raster.RasterConfig
import frustum.video.ResolvedPixel
import spinal.core._
import spinal.lib._

/** Sends finished tiles, one pixel per cycle while the sink takes them, and clears their memories at the same time: a
  * word is written with the clear value in the cycle after it was read. Tiles at the right and bottom edges of the
  * screen take as many cycles as complete ones, but only pixels on the screen are sent.
  *
  * Both banks hold the clear colour between tiles. A frame with another clear colour than the last (and the first one)
  * waits until nothing is in flight and clears both banks, which takes one cycle per word; otherwise `start` is taken
  * in its second cycle.
  */
case class Resolver(config: RasterConfig) extends Component {
  val io = new Bundle {
    val start = slave(Stream(FrameStart()))
    val drawing = in Bool () // fragments are in flight
    val tileEnd = slave(
      Flow(UInt(1 bits))
    ) // the bank whose tile is complete; never while one is being resolved
    val tile = slave(Stream(TilePosition())) // one for each tile, in order; taken when its resolve starts
    val clear = master(TileClear(config))
    val color = in Bits (16 bits)
    val clearColor = out Bits (16 bits)
    val pixels = master(Stream(ResolvedPixel(config)))
  }

  val pending, walking, clearing, clean = RegInit(False)
  val bank = Reg(UInt(1 bits))
  val position = Reg(TilePosition())
  val color = Reg(Bits(16 bits))
  val address = Reg(UInt(config.tileLog2Width + config.tileLog2Height bits)) init 0

  val tileStart = pending && !walking
  io.tile.ready := tileStart
  when(io.tileEnd.valid) { pending := True; bank := io.tileEnd.payload }
  when(io.tile.fire) { walking := True; position := io.tile.payload }

  val looked = RegNext(io.start.valid && !io.start.ready) init False // `same` is for the frame that is offered
  val same = RegNext(color === io.start.clearColor)
  io.start.ready := looked && clean && same
  when(looked && !(clean && same) && !io.drawing && !pending && !clearing) {
    color := io.start.clearColor
    clean := False
    clearing := True
  }

  /** The word whose data is at the memory's output. */
  val shown = new Area {
    val valid = RegInit(False)
    val address = Reg(Resolver.this.address)
    val visible = RegInit(False) // the pixel is on the screen, so it is sent
    val first = Reg(Bool()) // the first pixel of the tile
    val move = !visible || io.pixels.ready
    val last = valid && move && address.andR
  }
  val issue = (walking || clearing) && !(shown.valid && shown.address.andR)
  when(shown.move) {
    shown.valid := issue
    shown.address := address
    shown.first := address === 0
    shown.visible := issue && !clearing && onScreen(address, position)
    when(issue) { address := address + 1 }
  }
  when(shown.last) {
    walking := False
    clearing := False
    when(clearing) { clean := True } otherwise { pending := False }
  }

  io.clear.active := walking
  io.clear.all := clearing
  io.clear.bank := bank
  io.clear.read := shown.move
  io.clear.readAddress := address
  io.clear.write := shown.valid
  io.clear.writeAddress := shown.address
  io.clear.done := shown.last && walking
  io.clearColor := color

  io.pixels.valid := shown.visible
  io.pixels.color := io.color
  io.pixels.first := shown.first
  io.pixels.tileX := position.tileX
  io.pixels.tileY := position.tileY

  private def onScreen(address: UInt, tile: TilePosition): Bool = {
    def within(position: UInt, tile: UInt, tiles: Int, size: Int, pixels: Int): Bool = {
      val rest = pixels - (tiles - 1) * size
      if (rest == size) True else tile =/= tiles - 1 || position < rest
    }
    within(
      address.take(config.tileLog2Width).asUInt,
      tile.tileX,
      config.tilesX,
      config.tileWidth,
      config.width
    ) &&
    within(
      address.drop(config.tileLog2Width).asUInt,
      tile.tileY,
      config.tilesY,
      config.tileHeight,
      config.height
    )
  }
}
