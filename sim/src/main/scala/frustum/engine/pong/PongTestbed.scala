package frustum.engine.pong

import frustum.boards
import frustum.boards.icebreaker.IcebreakerTops
import frustum.demos.pong.{PongPipeline, PongPipelineConfig}
import frustum.device.Tech
import frustum.peripheral.SimVideoMonitor
import spinal.core._
import spinal.core.sim._

/** The top of a board that plays pong. */
sealed abstract class PongBoard(val top: String)

object PongBoard {
  case object Icebreaker extends PongBoard("icebreaker-pong")
  case object Arty extends PongBoard("arty-pong")
  val all: Seq[PongBoard] = Seq(Icebreaker, Arty)
}

/** A board's top with a monitor at its pins, and buttons, high when pressed. A VGA plug does not tell which clocks are
  * visible: that monitor goes by the pulses alone.
  */
case class PongTestbed(config: PongPipelineConfig, board: PongBoard) extends Component {
  val io = new Bundle { val up, down, left, right = in Bool () }
  val monitor = SimVideoMonitor(config.mode, config.format.bits)
  private val pins = monitor.io.pins
  private val clock = ClockDomain.current

  val pipeline: PongPipeline = board match {
    case PongBoard.Icebreaker =>
      val top = boards.icebreaker.PongTop(config, IcebreakerTops.pongMHz, Tech.Generic)
      asynchronous(top)
      top.io.clk := clock.readClockWire
      top.io.up := io.up
      top.io.down_n := !io.down
      top.io.left := io.left
      top.io.right := io.right
      pins.hSync := top.io.dvi_hSync
      pins.vSync := top.io.dvi_vSync
      pins.active := top.io.dvi_de
      pins.color := top.io.dvi_red ## top.io.dvi_green ## top.io.dvi_blue
      top.core.pipeline
    case PongBoard.Arty =>
      val top = boards.arty.PongTop(config, Tech.Generic)
      asynchronous(top)
      top.io.clk := clock.readClockWire
      top.io.resetn := !clock.readResetWire
      top.io.up := io.up
      top.io.down := io.down
      top.io.left := io.left
      top.io.right := io.right
      pins.hSync := top.io.vga_hSync
      pins.vSync := top.io.vga_vSync
      pins.active := monitor.io.visible
      pins.color := top.io.vga_red ## top.io.vga_green ## top.io.vga_blue
      top.core.pipeline
  }

  /** Both sides run from one clock, which the top's clock tree hides from the check. */
  private def asynchronous(top: Component): Unit = top.getAllIo.foreach(_.addTag(crossClockDomain))

  private val game = pipeline.game.io
  Seq(game.tens, game.ones, game.won).foreach(_.simPublic())

  def latencyClocks: Int = pipeline.latencyClocks
  def score: Int = game.tens.toInt * 10 + game.ones.toInt
  def won: Boolean = game.won.toBoolean
}
