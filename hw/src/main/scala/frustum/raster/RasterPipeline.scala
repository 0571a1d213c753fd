package frustum.raster

import frustum.contract.raster.{RasterConfig, StoreLayout}
import frustum.device.Tech
import frustum.raster.link.{CommandLink, LinkStatus}
import frustum.raster.store.{FrameJob, Store}
import frustum.video.ResolvedPixel
import spinal.core._
import spinal.lib._

/** Triangles: from the bytes of the command set to finished pixels, tile by tile.
  *
  * {{{
  * bytes -> CommandLink -> Store -> Rasterizer -> FragmentPipeline -> pixels
  *               '------- texels --------------------'
  * }}}
  * A frame is drawn while the next one arrives in the store's other bank. Every port but `pixels` must become ready in
  * the end; the sink of `pixels` sets the rate.
  *
  * @param dropWhenFull see [[frustum.raster.link.Framer]]: true behind a source that cannot wait, such as an SPI slave
  */
case class RasterPipeline(
    config: RasterConfig,
    dropWhenFull: Boolean = false,
    tech: Tech = Tech.Generic
) extends Component {
  val io = new Bundle {
    val bytes = slave(Stream(Bits(8 bits)))
    val pixels = master(Stream(ResolvedPixel(config)))
    val status = out(LinkStatus())

    /** A triangle was set up as a whole, moved to a tile, or left out of the frame because it faces away or has no
      * area: for measurements.
      */
    val setUp, moved, undrawn = out Bool ()

    /** A frame is being drawn; low for a cycle at least between frames. Its last pixels may follow. */
    val drawing = out Bool ()
  }
  val link = CommandLink(config, dropWhenFull = dropWhenFull)
  val store = Store(StoreLayout(config), clients = 4, tech)
  val rasterizer = Rasterizer(config, tech)
  val fragments = FragmentPipeline(config, tech)

  link.io.bytes << io.bytes
  (rasterizer.io.stores :+ link.io.store).zip(store.io.clients).foreach { case (client, port) => client <> port }
  // Texels come while nothing is drawn, so that the texture unit takes each at once: its ready would be a long path.
  val texels = link.io.texels.validPipe().toFlow
  texels.toStream >> fragments.io.texels
  assert(fragments.io.texels.ready || !texels.valid, "a texel is lost, as it came while a frame was drawn")
  // The resolver takes a tile's position when the tile is drawn; the rasterizer is at a later one by then.
  rasterizer.io.tile.m2sPipe().m2sPipe() >> fragments.io.tile
  rasterizer.io.down >> fragments.io.up
  fragments.io.state := rasterizer.io.state
  rasterizer.io.draining := fragments.io.busy
  fragments.io.pixels >> io.pixels

  // A frame starts in the tile memories, then in the rasterizer, which releases it when it is drawn. It waits here, so
  // that the decoder can begin the next.
  val job = link.io.job.halfPipe()
  val started = RegInit(False) setWhen fragments.io.start.fire clearWhen job.fire
  fragments.io.start.valid := job.valid && !started
  fragments.io.start.clearColor := job.clearColor
  rasterizer.io.frame.valid := job.valid && started
  rasterizer.io.frame.payload := job.payload
  job.ready := rasterizer.io.frame.ready
  link.io.jobDone := job.fire
  link.io.undrawn := rasterizer.io.undrawn

  io.status := link.io.status
  io.setUp := rasterizer.io.setUp
  io.moved := rasterizer.io.moved
  io.undrawn := rasterizer.io.undrawn
  io.drawing := job.valid
}
