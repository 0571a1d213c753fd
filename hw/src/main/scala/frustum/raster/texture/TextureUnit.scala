package frustum.raster.texture

import frustum.contract.raster.RasterConfig
import frustum.device.{SinglePortRam, Tech}
import frustum.raster.store.RenderStateWord
import spinal.core._
import spinal.lib._

/** Nearest texel at a coordinate: wrap, address, fetch, decode; one per cycle, latency 3 cycles, or 2 where there is
  * one texture alone.
  *
  * Texel memory has one port. A write that is offered stops reads, and is done when the last texel that was read has
  * been taken, since a write invalidates the memory's output; then writes go at one per cycle. `state` must be stable
  * while `busy`, and from the cycle before the first coordinate that it concerns.
  */
case class TextureUnit(config: RasterConfig, tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val up = slave(Stream(TextureCoordinate()))
    val state = in(RenderStateWord())
    val texels = slave(Stream(TexelWrite()))
    val down = master(Stream(Texel()))
    val fetch = out Bool () // a texel is being read, which comes in the next cycle
    val busy = out Bool ()
  }

  case class TexelIndex() extends Bundle {
    val s, t = UInt(7 bits)
  }

  val columns = new TexelAddress.Axis(io.state.wrapS, io.state.log2Width)
  val rows = new TexelAddress.Axis(io.state.wrapT, io.state.log2Height)
  val wrapped = io.up.translateWith {
    val index = TexelIndex()
    index.s := TexelAddress.index(io.up.s, columns)
    index.t := TexelAddress.index(io.up.t, rows)
    index
  }
  val indexed = wrapped.m2sPipe(collapsBubble = false)
  private val placed = indexed.translateWith(TexelAddress(indexed.s, indexed.t, columns, io.state))
  // A constant texture's address needs little more logic than its index.
  val addressed = if (config.fixed.whole) placed else placed.m2sPipe(collapsBubble = false)
  val read = addressed.haltWhen(io.texels.valid)
  val fetched = read.translateWith(NoData()).m2sPipe(collapsBubble = false)

  val memory = SinglePortRam(config.textureTexels, 16, tech)
  val address = Mux(io.texels.valid, io.texels.address, addressed.payload)
  memory.io.enable := Mux(io.texels.valid, io.texels.ready, fetched.ready)
  memory.io.write := io.texels.fire
  memory.io.address := address.resized
  memory.io.writeData := io.texels.data
  memory.io.mask := 1
  io.texels.ready := !fetched.valid

  io.down << fetched.translateWith(Texel.decode(memory.io.readData, io.state.texelFormat))
  io.fetch := read.fire
  io.busy := indexed.valid || addressed.valid || fetched.valid
}
