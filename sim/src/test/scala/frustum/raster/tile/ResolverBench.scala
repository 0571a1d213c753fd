package frustum.raster.tile

import frustum.contract.raster.RasterConfig
import frustum.video.ResolvedPixel
import spinal.core._
import spinal.lib._

case class TileStroke(config: RasterConfig) extends Bundle {
  val at = UInt(config.tileLog2Width + config.tileLog2Height bits)
  val color = Bits(16 bits)
  val tileEnd = Bool()
}

/** The resolver with a tile memory that is drawn to as the fragment stages do: not before the frame has started, and a
  * tile's end not before the tile before is resolved.
  */
class ResolverBench(config: RasterConfig) extends Component {
  val io = new Bundle {
    val start = slave(Stream(FrameStart()))
    val tile = slave(Stream(TilePosition()))
    val up = slave(Stream(TileStroke(config)))
    val pixels = master(Stream(ResolvedPixel(config)))
  }
  val unit = Resolver(config)
  val memory = TileMemory(config, 16, resolved = true)
  unit.io.tile << io.tile
  io.pixels << unit.io.pixels

  val tiles = Counter(config.tilesX * config.tilesY)
  val started = RegInit(False) setWhen unit.io.start.fire
  unit.io.start << io.start.haltWhen(started)
  val resolving = RegInit(False) clearWhen unit.io.clear.done
  val up = io.up.haltWhen(!started || io.up.tileEnd && resolving).toFlow
  val ends = up.valid && up.tileEnd
  when(ends) {
    resolving := True
    tiles.increment()
    when(tiles.willOverflowIfInc) { started := False }
  }
  val bank = RegInit(U(0, 1 bits))
  when(ends) { bank := ~bank }
  unit.io.drawing := RegNext(up.valid) init False
  unit.io.tileEnd.valid := RegNext(ends) init False
  unit.io.tileEnd.payload := RegNext(bank)

  memory.io.readEnable := False
  memory.io.readBank.assignDontCare()
  memory.io.readAddress.assignDontCare()
  memory.io.writeEnable := (up.valid && !up.tileEnd) #* 2 & UIntToOh(bank)
  memory.io.writeAddress := up.at
  memory.io.writeData := up.color
  memory.io.clear <> unit.io.clear
  memory.io.clearValue := unit.io.clearColor
  unit.io.color := memory.io.resolvedData
}
