package frustum.fragment

import frustum.frame.{TileClear, TileMemory}
import frustum.raster.RenderStateWord
import frustum.spec.RasterConfig
import spinal.core._
import spinal.lib._

/** Writes pixels to the colour buffer of one tile, in two banks, blended by source alpha where the state says
  * so; one a clock, latency 2 clocks, never stalls; the depth
  * test is made meanwhile. [[Interlock]] keeps pixels apart that are still being
  * blended.
  *
  * With w = a + (a >> 4), 0..32, a channel becomes (src w + dst (32 - w) + 16) >> 5, exact at both ends.
  * Since w is the sum of a's bits at their weights and of bit 4 once more, that is a sum of six terms, each
  * src or dst.
  */
case class Blend(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(Flow(PixelWrite(config)))
    val passed = in Bool () // whether what entered a clock ago is to be written
    val state = in(RenderStateWord())
    val clear = slave(TileClear(config))
    val clearColor = in Bits (16 bits)
    val color = out Bits (16 bits) // for the resolver
    val tileEnd = master(Flow(UInt(1 bits)))
    val busy = out Bool ()
  }

  val memory = TileMemory(config, 16, resolved = true)
  memory.io.clear <> io.clear
  memory.io.clearValue := io.clearColor
  io.color := memory.io.resolvedData

  /** Two partial sums of a channel: `low` holds the terms of weights 1 and 2, `high` those of 4 and 8. */
  case class Partial(width: Int) extends Bundle {
    val low, high = UInt(width + 2 bits)
    val top = UInt(width bits)
    def sum: UInt = {
      val rounded = (((low ## True).asUInt +^ (top ## True).asUInt) >> 1).resize(width + 3)
      val upper = (high ## B"11").asUInt +^ (top ## B"1100").asUInt // 15 in the bits that are free
      ((upper + rounded.resize(width + 5)) >> 5).resize(width)
    }
  }
  case class Mixed() extends Bundle {
    val address = UInt(widthOf(io.up.address) bits)
    val bank = UInt(1 bits)
    val r = Partial(5)
    val g = Partial(6)
    val b = Partial(5)
    val tileEnd = Bool()
  }

  val fetched = Flow(PixelWrite(config))
  val mixed = Flow(Mixed())
  fetched << io.up.m2sPipe
  memory.io.readEnable := True
  memory.io.readBank := io.up.bank
  memory.io.readAddress := io.up.address

  val stored = memory.io.readData
  val takeSource = fetched.a.asBits | !io.state.blend #* 5
  val mixing = Mixed()
  mixing.address := fetched.address
  mixing.bank := fetched.bank
  mixing.tileEnd := fetched.tileEnd
  for (
    (partial, source, target) <- Seq(
      (mixing.r, fetched.r, stored(15 downto 11)),
      (mixing.g, fetched.g, stored(10 downto 5)),
      (mixing.b, fetched.b, stored(4 downto 0))
    )
  ) {
    val terms = takeSource.asBools.map(Mux(_, source, target.asUInt))
    partial.low := ((terms(1) << 1) +^ terms(0)).resized
    partial.high := ((terms(3) << 1) +^ terms(2)).resized
    partial.top := terms(4)
  }
  mixed << fetched.takeWhen(io.passed).translateWith(mixing).m2sPipe

  memory.io.writeEnable := mixed.valid && !mixed.tileEnd
  memory.io.writeBank := mixed.bank
  memory.io.writeAddress := mixed.address
  // Without blending, synthesis would not see that the sums of equal terms are those terms.
  memory.io.writeData := (
    if (config.fixed.neverBlends) RegNext(fetched.r ## fetched.g ## fetched.b)
    else mixed.r.sum ## mixed.g.sum ## mixed.b.sum
  )

  io.tileEnd.valid := mixed.valid && mixed.tileEnd
  io.tileEnd.payload := mixed.bank
  io.busy := fetched.valid || mixed.valid
}
