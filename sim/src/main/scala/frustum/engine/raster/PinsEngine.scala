package frustum.engine.raster

import frustum.contract.InputError
import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.driver.raster.{Driver, PreparedFrame}
import frustum.engine.{Engine, EngineSim, SideBySide}
import spinal.core.sim.SimCompiled
import java.nio.file.Path

/** The board's top in simulation, at its pins: a host sends the commands by SPI and honours `cts`, a display controller
  * with a memory of its own takes what comes, and the picture is read from that memory. A frame is sent when the one
  * before is complete. What the display would not put up with is an error.
  */
final class PinsEngine(options: EngineOptions) extends Engine[PreparedFrame, RenderedFrame] {
  import options.panel

  def draw(works: Iterator[PreparedFrame])(each: RenderedFrame => Unit): Unit = if (works.hasNext) {
    val frames = works.buffered
    val config = frames.head.config
    panel.fault(config.width, config.height).foreach(fault =>
      throw InputError(s"--size ${config.width}x${config.height}: $fault; take a smaller one or --engine pipeline")
    )
    EngineSim.run(PinsEngine.compile(config, panel, options.wave), options.wave, options.seed) { dut =>
      val session = new PinsSession(dut)
      session.run(PinsEngine.DisplayStartClocks)
      session.send(frames.head.textures.flatMap(Driver.commands).flatten, wait = true)
      frames.foreach { frame =>
        val bytes = frame.passes.flatMap(Driver.commands).flatten
        val clocks = session.frame(bytes, config.width * config.height)
        session.controller.violations.headOption.foreach(v =>
          throw new IllegalStateException(s"the ${panel.name} would not put up with this: $v")
        )
        each(RenderedFrame(
          session.controller.picture(config.width, config.height),
          clocksAtPins = Some(clocks),
          busBytes = Some(bytes.length.toLong)
        ))
      }
    }
  }
}

object PinsEngine {

  /** The display's start, its pauses shortened, is over after so many clocks: frames are not to be charged with it. */
  val DisplayStartClocks = 10000

  def compile(config: RasterConfig, panel: Panel, wave: Option[Path] = None): SimCompiled[PinsTestbed] =
    EngineSim.compile(s"Pins_${panel.name}_${EngineSim.nameOf(config)}", wave)(PinsTestbed(config, panel))
}

/** The board's top at its pins, and beside it, in a thread of its own, its Stream core for the figures that the
  * display's pace hides. Both must draw the same picture. Takes works ahead as [[PipelineEngine]] does.
  */
final class HardwareEngine(options: EngineOptions) extends Engine[PreparedFrame, RenderedFrame] {
  def draw(works: Iterator[PreparedFrame])(each: RenderedFrame => Unit): Unit = {
    val (forPins, forCore) = works.duplicate
    val pins = new PinsEngine(options)
    val core = new PipelineEngine(options.copy(wave = None))
    var index = 0
    SideBySide[RenderedFrame, RenderedFrame](pins.draw(forPins), core.draw(forCore)) { (p, c) =>
      if (!p.image.sameElements(c.image))
        throw new IllegalStateException(s"frame $index differs between pins and Stream core")
      index += 1
      each(c.copy(image = p.image, clocksAtPins = p.clocksAtPins))
    }
  }
}
