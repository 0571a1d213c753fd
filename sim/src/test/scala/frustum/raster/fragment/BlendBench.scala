package frustum.raster.fragment

import frustum.contract.raster.RasterConfig
import frustum.device.Tech
import frustum.raster.store.RenderStateWord
import frustum.raster.tile.TileSweep
import spinal.core._
import spinal.lib._

case class BlendFragment(config: RasterConfig) extends Bundle {
  val at = UInt(config.tileLog2Width + config.tileLog2Height bits)
  val color = Bits(16 bits)
  val a = UInt(5 bits)
  val passed = Bool()
  val tileEnd = Bool()
}

/** Blending with a sweep that sends each tile's words when it has ended. */
class BlendBench(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(Stream(BlendFragment(config)))
    val state = in(RenderStateWord())
    val clearColor = in Bits (16 bits)
    val down = master(Stream(Bits(16 bits)))
  }
  val words = config.tileWidth * config.tileHeight
  val unit = Blend(config, Tech.Generic)
  val sweep = TileSweep(config)
  unit.io.state := io.state
  unit.io.clear <> sweep.io.clear
  unit.io.clearColor := io.clearColor
  sweep.io.tileEnd << unit.io.tileEnd
  val fifo = StreamFifo(Bits(16 bits), 2 * words)
  fifo.io.push.valid := sweep.io.word
  fifo.io.push.payload := unit.io.color
  io.down << fifo.io.pop

  val bank = RegInit(U(0, 1 bits))
  val ending = RegInit(U(0, 2 bits)) // a mark is on its way to the sweep
  val mayEnd = ending === 0 && sweep.io.resting && fifo.io.availability >= words
  val up = io.up.haltWhen(sweep.io.clear.all || io.up.tileEnd && !mayEnd).toFlow
  ending := (ending ## (up.valid && up.tileEnd)).asUInt.resized
  when(up.valid && up.tileEnd) { bank := ~bank }
  unit.io.up.valid := up.valid
  unit.io.up.address := up.at
  unit.io.up.bank := bank
  unit.io.up.r := up.color(15 downto 11).asUInt
  unit.io.up.g := up.color(10 downto 5).asUInt
  unit.io.up.b := up.color(4 downto 0).asUInt
  unit.io.up.a := up.a
  unit.io.up.tileEnd := up.tileEnd
  unit.io.passed := RegNext(up.passed || up.tileEnd)
}
