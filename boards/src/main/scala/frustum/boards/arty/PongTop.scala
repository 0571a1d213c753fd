package frustum.boards.arty

import frustum.demos.pong.{PongPipeline, PongPipelineConfig}
import frustum.device.{Artix7ClockDivider, Tech}
import spinal.core._

/** `arty-pong`: four buttons, 3-D pong, a VGA PMOD. The pixel clock is a quarter of the oscillator's 100 MHz. */
case class PongTop(config: PongPipelineConfig, tech: Tech) extends Component {
  val io = PongPins()
  noIoPrefix()

  val clocking = new Area {
    val divider = Artix7ClockDivider(tech)
    divider.io.clockIn := io.clk
    val domain = ArtyDomain(divider.io.clockOut, io.resetn, 25 MHz)
  }
  val core = new ClockingArea(clocking.domain) {
    val pipeline = PongPipeline(config, tech, fast = true)
    pipeline.io.buttons.up := io.up
    pipeline.io.buttons.down := io.down
    pipeline.io.buttons.left := io.left
    pipeline.io.buttons.right := io.right
    io.vga_red := pipeline.io.video.red
    io.vga_green := pipeline.io.video.green
    io.vga_blue := pipeline.io.video.blue
    io.vga_hSync := pipeline.io.video.hSync
    io.vga_vSync := pipeline.io.video.vSync
  }
}
