package frustum.boards.arty

import frustum.blackbox.{Artix7ClockDivider, Tech}
import frustum.pipelines.{PongPipeline, PongPipelineConfig}
import spinal.core._
import spinal.lib.ResetCtrl

/** `arty-pong`: four buttons, 3-D pong, a VGA PMOD. The pixel clock is a quarter of the oscillator's 100 MHz. */
case class PongTop(config: PongPipelineConfig, tech: Tech) extends Component {
  val io = PongPins()
  noIoPrefix()

  val clocking = new Area {
    val divider = Artix7ClockDivider(tech)
    divider.io.clockIn := io.clk
    private val unreset = ClockDomain(divider.io.clockOut, config = ClockDomainConfig(resetKind = BOOT))
    val domain          = ClockDomain(
      clock = divider.io.clockOut,
      reset =
        ResetCtrl.asyncAssertSyncDeassert(!io.resetn, unreset, inputPolarity = HIGH, outputPolarity = HIGH),
      frequency = ClockDomain.FixedFrequency(25 MHz)
    )
  }
  val core = new ClockingArea(clocking.domain) {
    val pipeline = PongPipeline(config, tech)
    pipeline.io.buttons.up    := io.up
    pipeline.io.buttons.down  := io.down
    pipeline.io.buttons.left  := io.left
    pipeline.io.buttons.right := io.right
    io.vga_red                := pipeline.io.video.red
    io.vga_green              := pipeline.io.video.green
    io.vga_blue               := pipeline.io.video.blue
    io.vga_hSync              := pipeline.io.video.hSync
    io.vga_vSync              := pipeline.io.video.vSync
  }
}
