package frustum.texture

import frustum.blackbox.{SinglePortRam, Tech}
import frustum.raster.RenderStateWord
import frustum.spec.RasterConfig
import spinal.core._
import spinal.lib._

/** Nearest texel at a coordinate: wrap, address, fetch, decode; one a clock, latency 2 clocks.
  *
  * Texel memory has one port. A write takes it for a clock, in which no texel is read; it waits while a texel that was
  * read has not been taken. `state` must be stable while `busy`.
  */
case class TextureUnit(config: RasterConfig, tech: Tech) extends Component {
  val io = new Bundle {
    val up     = slave(Stream(TextureCoordinate()))
    val state  = in(RenderStateWord())
    val texels = slave(Stream(TexelWrite()))
    val down   = master(Stream(Texel()))
    val busy   = out Bool ()
  }

  case class TexelIndex() extends Bundle {
    val s, t = UInt(7 bits)
  }

  val wrapped = io.up.translateWith {
    val index = TexelIndex()
    index.s := TexelAddress.index(io.up.s, io.state.wrapS, io.state.log2Width)
    index.t := TexelAddress.index(io.up.t, io.state.wrapT, io.state.log2Height)
    index
  }
  val indexed = wrapped.m2sPipe(collapsBubble = false)
  val read    = indexed.haltWhen(io.texels.fire)
  val fetched = read.translateWith(NoData()).m2sPipe(collapsBubble = false)

  val memory  = SinglePortRam(config.textureTexels, 16, tech)
  val address = Mux(io.texels.fire, io.texels.address, TexelAddress(indexed.s, indexed.t, io.state))
  memory.io.enable    := io.texels.fire || read.fire
  memory.io.write     := io.texels.fire
  memory.io.address   := address.resized
  memory.io.writeData := io.texels.data
  memory.io.mask      := 1
  io.texels.ready     := !fetched.valid || fetched.ready

  io.down << fetched.translateWith(Texel.decode(memory.io.readData, io.state.rgba4444))
  io.busy := indexed.valid || fetched.valid
}
