package frustum.raster.link

import frustum.contract.raster.{RasterConfig, StoreLayout}
import frustum.raster.store.{FrameJob, StoreBus}
import frustum.raster.texture.TexelWrite
import spinal.core._
import spinal.lib._

/** The input path: bytes of the wire to scene store, texel memory and jobs, with everything counted.
  *
  * @param dropWhenFull see [[Framer]]: true behind a source that cannot wait, such as [[SpiSlave]]
  */
case class CommandLink(config: RasterConfig, depth: Int = 256, dropWhenFull: Boolean = false) extends Component {
  val io = new Bundle {
    val bytes = slave(Stream(Bits(8 bits)))
    val store = master(StoreBus(StoreLayout(config)))
    val texels = master(Stream(TexelWrite()))
    val job = master(Stream(FrameJob(config)))
    val jobDone = in Bool ()
    val undrawn = in Bool () // a triangle of the job was
    val drawing = out Bool ()
    val status = out(LinkStatus())
  }

  val framer = Framer(depth, dropWhenFull)
  val decoder = CommandDecoder(config)
  framer.io.bytes << io.bytes
  decoder.io.words << framer.io.words
  decoder.io.store <> io.store
  decoder.io.texels >> io.texels
  decoder.io.job >> io.job
  decoder.io.jobDone := io.jobDone
  io.drawing := decoder.io.drawing

  def counter(event: Bool): UInt = {
    val count = RegInit(U(0, LinkStatus.CountBits bits))
    when(event)(count := count + 1)
    count
  }
  val events = DecoderEvents() // a cycle late, so that the counters are not in the path of a decision
  def pulses(events: DecoderEvents) = events.elements.map { case (_, pulse: Bool) => pulse }
  for ((late, pulse) <- pulses(events).zip(pulses(decoder.io.events))) late := RegNext(pulse) init False
  // Two units drop commands; where both do so in one cycle, the decoder's is counted later. The decoder has no drop in
  // between.
  val refused = RegInit(False) setWhen events.refused clearWhen (!framer.io.dropped && !events.refused)
  val dropped = framer.io.dropped || refused

  io.status.busy := decoder.io.drawing
  io.status.cts := framer.io.room
  io.status.accepted := counter(events.accepted)
  io.status.dropped := counter(dropped)
  io.status.verticesRefused := counter(events.vertexRefused)
  io.status.trianglesRefused := counter(events.triangleRefused)
  io.status.incomplete := counter(events.incomplete)
  io.status.drawn := counter(io.jobDone)
  io.status.counting := Bool(config.countUndrawn)
  io.status.trianglesUndrawn := (if (config.countUndrawn) counter(io.undrawn) else U(0))
  io.status.error := RegInit(False) setWhen
    (dropped || events.vertexRefused || events.triangleRefused || events.incomplete)
}
