package frustum.raster.fragment

import frustum.contract.raster.{RasterConfig, SetupWords}
import frustum.raster.store.RenderStateWord
import frustum.raster.tile.{TileClear, TileMemory}
import spinal.core._
import spinal.lib._

/** Depth test against a 16-bit depth buffer of one tile, in two banks that change at a tile-end marker; one fragment
  * per cycle, latency 1 cycle, never stalls.
  *
  * A fragment reads its word when it enters, which selects its bank, and writes it a cycle later, when `z` is its depth
  * and `passed` the result: [[Interlock]] keeps fragments of one pixel apart. The memory holds the complement of the
  * depth, so that carries alone compare. Where every state lets all fragments pass there is no memory.
  */
case class DepthStage(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(Flow(ColoredFragment(config)))
    val state = in(RenderStateWord())
    val clear = slave(TileClear(config))
    val down = master(Flow(PixelWrite(config))) // as they enter, not tested yet
    val z = in UInt (16 bits)
    val passed = out Bool () // tile-end markers always pass
    val busy = out Bool ()
  }

  val bank = RegInit(U(0, 1 bits))
  when(io.up.valid && io.up.tileEnd) { bank := ~bank }
  val stored = if (config.fixed.planes.contains(SetupWords.PlaneZ)) io.up.m2sPipe else io.up
  val test = config.fixed.planes.contains(SetupWords.PlaneZ) generate new Area {
    val memory = TileMemory(config, 16, resolved = false)
    memory.io.clear <> io.clear
    memory.io.clearValue := 0
    memory.io.readEnable := True
    memory.io.readBank := bank
    memory.io.readAddress := io.up.address

    // The bank that the fragment may be written to.
    val writes = RegNext((io.up.valid && !io.up.tileEnd && io.state.depthWrite) #* 2 & UIntToOh(bank)) init 0
    val complement = memory.io.readData.asUInt
    val passing = io.state.depthFunction
    // z + ~depth overflows where z is greater, and with a carry in where z is no less. Two carry chains: synthesis
    // makes a comparison for equality of many levels of logic.
    val farther = (io.z +^ complement).msb
    val nearer = !((io.z ## True).asUInt +^ (complement ## True).asUInt).msb
    val pass = Mux(nearer, passing(0), Mux(farther, passing(2), passing(1)))
    memory.io.writeEnable := pass #* 2 & writes
    memory.io.writeAddress := stored.address
    memory.io.writeData := ~io.z.asBits

    io.passed := stored.tileEnd || pass
  }
  if (test == null) io.passed := True
  io.down.valid := io.up.valid
  io.down.payload.assignSomeByName(io.up.payload.asInstanceOf[Bundle])
  io.down.address := io.up.address
  io.down.bank := bank
  io.busy := stored.valid
}
