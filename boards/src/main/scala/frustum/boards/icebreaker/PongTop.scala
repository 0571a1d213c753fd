package frustum.boards.icebreaker

import frustum.demos.pong.{PongPipeline, PongPipelineConfig}
import frustum.device.{ClockOutput, Tech}
import spinal.core._

/** `icebreaker-pong`: four buttons, 3-D pong, a 12-bit DVI PMOD.
  *
  * @param pixelMHz pixel clock
  */
case class PongTop(config: PongPipelineConfig, pixelMHz: BigDecimal, tech: Tech) extends Component {
  val io = PongPins()
  noIoPrefix()

  val clocking = new IcebreakerClock(io.clk, True, pixelMHz, tech)
  val core = new ClockingArea(clocking.domain) {
    val pipeline = PongPipeline(config, tech)
    val clock = ClockOutput(tech)
    pipeline.io.buttons.up := io.up
    pipeline.io.buttons.down := !io.down_n
    pipeline.io.buttons.left := io.left
    pipeline.io.buttons.right := io.right
    io.dvi_red := pipeline.io.video.red
    io.dvi_green := pipeline.io.video.green
    io.dvi_blue := pipeline.io.video.blue
    io.dvi_hSync := pipeline.io.video.hSync
    io.dvi_vSync := pipeline.io.video.vSync
    io.dvi_de := pipeline.io.video.active
    io.dvi_clk := clock.io.pin
  }
}
