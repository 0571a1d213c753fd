package frustum.engine.raster

import frustum.contract.raster.RasterConfig
import frustum.driver.raster.{Driver, PreparedFrame}
import frustum.engine.{Engine, EngineSim}
import spinal.core.sim.SimCompiled
import java.nio.file.Path

/** The Stream core in simulation: command bytes are fed as fast as they are taken, pixels taken as they come. While a
  * frame is drawn the next one's bytes arrive: all works are taken before the first frame.
  *
  * @param byteStall,pixelStall see [[PipelineSession]]
  */
final class PipelineEngine(options: EngineOptions, byteStall: Double = 0, pixelStall: Double = 0)
    extends Engine[PreparedFrame, RenderedFrame] {

  def draw(works: Iterator[PreparedFrame])(each: RenderedFrame => Unit): Unit = if (works.hasNext) {
    val frames = works.toSeq
    val config = frames.head.config
    EngineSim.run(PipelineEngine.compile(config, options.wave), options.wave, options.seed) { dut =>
      val session = new PipelineSession(dut, options.seed, byteStall, pixelStall)
      frames.head.textures.flatMap(Driver.commands).foreach(session.send)
      frames.flatMap(_.passes).flatMap(Driver.commands).foreach(session.send)
      val drawn = frames.map { frame =>
        val image = new Array[Int](config.width * config.height)
        val passes = frame.passes.map(session.take(_, image))
        RenderedFrame(
          image,
          clocks = Some(passes.map(_.clocks).sum),
          busBytes = Some(PipelineEngine.busBytes(frame)),
          setUps = Some(passes.map(_.setUps.toLong).sum),
          moves = Some(passes.map(_.moves.toLong).sum),
          undrawn = Some(passes.map(_.undrawn.toLong).sum)
        )
      }
      if (session.faulty) throw new IllegalStateException(s"the link refused what the driver sent: ${session.status}")
      drawn.foreach(each)
    }
  }
}

object PipelineEngine {
  def busBytes(frame: PreparedFrame): Long = frame.passes.flatMap(Driver.commands).map(_.length.toLong).sum

  def compile(config: RasterConfig, wave: Option[Path] = None): SimCompiled[PipelineTestbed] =
    EngineSim.compile(s"Pipeline_${EngineSim.nameOf(config)}", wave)(PipelineTestbed(config))
}
