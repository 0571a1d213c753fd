package frustum.raster.fragment

import frustum.arithmetic.MultiplyAddPair
import frustum.contract.raster.RasterConfig
import frustum.device.Tech
import frustum.raster.store.RenderStateWord
import frustum.raster.tile.{TileClear, TileMemory}
import spinal.core._
import spinal.lib._

/** Writes pixels to the colour buffer of one tile, in two banks, blended by source alpha where the state says so; one
  * per cycle, latency 2 cycles, or 1 where no state can blend, or none where none tests depth either; never stalls; the
  * depth test is made meanwhile. [[Interlock]] keeps fragments of one pixel apart while it is blended.
  *
  * With w = a + (a >> 4), 0..32, a channel becomes (src w + dst (32 - w) + 16) >> 5, exact at both ends. That is dst 32
  * + 16 + (src - dst) w; in logic cells, since w is the sum of a's bits at their weights and of bit 4 once more, a sum
  * of six terms, each src or dst.
  */
case class Blend(config: RasterConfig, tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val up = slave(Flow(PixelWrite(config)))
    val passed = in Bool () // whether what entered a cycle ago is to be written
    val state = in(RenderStateWord())
    val clear = slave(TileClear(config))
    val clearColor = in Bits (16 bits)
    val color = out Bits (16 bits) // read data for the resolver
    val tileEnd = master(Flow(UInt(1 bits)))
    val busy = out Bool ()
  }

  private val blends = !config.fixed.neverBlends
  val memory = TileMemory(config, 16, resolved = true, drawnReads = blends)
  memory.io.clear <> io.clear
  memory.io.clearValue := io.clearColor
  io.color := memory.io.resolvedData

  case class Mixed() extends Bundle {
    val address = UInt(widthOf(io.up.address) bits)
    val bank = UInt(1 bits)
    val tileEnd = Bool()
  }

  val fetched = Flow(PixelWrite(config))
  val mixed = Flow(Mixed())
  fetched << (if (config.fixed.neverReads) io.up else io.up.m2sPipe)
  memory.io.readEnable := True
  memory.io.readBank := io.up.bank
  memory.io.readAddress := io.up.address

  val mixing = Mixed()
  mixing.assignSomeByName(fetched.payload)
  private val tested = fetched.takeWhen(io.passed).translateWith(mixing)
  mixed << (if (blends) tested.m2sPipe else tested)

  memory.io.writeEnable := (mixed.valid && !mixed.tileEnd) #* 2 & UIntToOh(mixed.bank)
  memory.io.writeAddress := mixed.address
  memory.io.writeData := (if (blends) mix else fetched.r ## fetched.g ## fetched.b)

  /** The colour for what is in `mixed`: red and blue by the multipliers, green by logic cells. */
  def mix: Bits = {
    val stored = memory.io.readData
    val weight = UInt(6 bits)
    weight := fetched.a +^ fetched.a.msb.asUInt
    when(!io.state.blend) { weight := 32 }

    val channels = Seq(fetched.b -> stored(4 downto 0), fetched.r -> stored(15 downto 11))
    val multipliers = MultiplyAddPair(tech)
    for (((source, target), i) <- channels.zipWithIndex) {
      multipliers.io.a(i) := (source.intoSInt - target.asUInt.intoSInt).resize(8)
      multipliers.io.b(i) := weight.resized
      multipliers.io.addend(i) := (target ## B"10000").asUInt.resized
    }
    val Seq(b, r) = multipliers.io.result.map(_(9 downto 5)).toSeq

    // Two partial sums: `low` holds the terms of weights 1 and 2, `high` those of 4 and 8.
    val takeSource = fetched.a.asBits | !io.state.blend #* 5
    val terms = takeSource.asBools.map(Mux(_, fetched.g, stored(10 downto 5).asUInt))
    val low = RegNext(((terms(1) << 1) +^ terms(0)).resize(8))
    val high = RegNext(((terms(3) << 1) +^ terms(2)).resize(8))
    val top = RegNext(terms(4))
    val rounded = (((low ## True).asUInt +^ (top ## True).asUInt) >> 1).resize(9)
    val upper = (high ## B"11").asUInt +^ (top ## B"1100").asUInt // 15 in the bits that are free
    val g = ((upper + rounded.resize(11)) >> 5).resize(6)
    r ## g ## b
  }

  io.tileEnd.valid := mixed.valid && mixed.tileEnd
  io.tileEnd.payload := mixed.bank
  io.busy := (if (config.fixed.neverReads) False else fetched.valid) || (if (blends) mixed.valid else False)
}
