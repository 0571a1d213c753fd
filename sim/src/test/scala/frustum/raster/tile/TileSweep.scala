package frustum.raster.tile

import frustum.contract.raster.RasterConfig
import spinal.core._
import spinal.lib._

/** Stands in for the resolver: after reset it clears both banks, after each tile's end that tile's bank, word after
  * word, two clocks each. `word` marks the clock in which the memory shows the word that goes.
  */
case class TileSweep(config: RasterConfig) extends Component {
  val io = new Bundle {
    val tileEnd = slave(Flow(UInt(1 bits)))
    val clear = master(TileClear(config))
    val word = out Bool ()
    val resting = out Bool () // another tile may end
  }
  val all = RegInit(True)
  val active = RegInit(False)
  val writing = RegInit(False)
  val bank = RegNextWhen(io.tileEnd.payload, io.tileEnd.valid)
  val address = Reg(UInt(config.tileLog2Width + config.tileLog2Height bits)) init 0
  val running = all || active

  writing := running && !writing
  when(writing) {
    address := address + 1
    when(address.andR) { all := False; active := False }
  }
  when(io.tileEnd.valid) { active := True }
  io.clear.active := active
  io.clear.all := all
  io.clear.bank := bank
  io.clear.read := running && !writing
  io.clear.readAddress := address
  io.clear.write := writing
  io.clear.writeAddress := address
  io.clear.done := writing && address.andR && active
  io.word := writing && active
  io.resting := !running && !io.tileEnd.valid
}
