package frustum.fragment

import frustum.frame.{TileClear, TileMemory}
import frustum.raster.RenderStateWord
import frustum.spec.RasterConfig
import spinal.core._
import spinal.lib._

/** Depth test against a 16-bit depth buffer of one tile, in two banks; one fragment a clock, latency 1 clock.
  *
  * A fragment reads its word when it enters and writes it a clock later; one that follows on the same pixel waits that
  * clock. Tiles change banks at their end mark, which waits until the tile before has been resolved.
  */
case class DepthTest(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up    = slave(Stream(ColoredFragment(config)))
    val state = in(RenderStateWord())
    val clear = slave(TileClear(config))
    val down  = master(Stream(PixelWrite(config)))
    val busy  = out Bool ()
  }

  val bank       = RegInit(U(0, 1 bits)) // of the fragment that enters
  val handedOver = RegInit(False)        // a tile has ended and is not resolved yet
  val memory     = TileMemory(config, 16, resolved = false)
  memory.io.clear      <> io.clear
  memory.io.clearValue := 0xffff

  val stored = Stream(ColoredFragment(config))
  val hazard = stored.valid && stored.address === io.up.address
  val read   = io.up.haltWhen(hazard || io.clear.all || handedOver && io.up.tileEnd)
  stored << read.m2sPipe(collapsBubble = false)
  memory.io.readEnable  := read.ready
  memory.io.readBank    := bank
  memory.io.readAddress := read.address
  val storedBank = RegNextWhen(bank, read.ready)
  when(io.clear.done) { handedOver := False }
  when(read.fire && read.tileEnd) { handedOver := True; bank := ~bank }

  val nearer  = stored.z < memory.io.readData.asUInt
  val equal   = stored.z === memory.io.readData.asUInt
  val passing = io.state.depthFunction
  val pass    = Mux(equal, passing(1), Mux(nearer, passing(0), passing(2)))
  memory.io.writeEnable  := stored.valid && !stored.tileEnd && pass && io.state.depthWrite
  memory.io.writeBank    := storedBank
  memory.io.writeAddress := stored.address
  memory.io.writeData    := stored.z.asBits

  io.down << stored.throwWhen(!pass && !stored.tileEnd).translateWith {
    val pixel = PixelWrite(config)
    pixel.assignSomeByName(stored.payload.asInstanceOf[Bundle])
    pixel.address := stored.address
    pixel.bank    := storedBank
    pixel
  }
  io.busy := stored.valid
}
