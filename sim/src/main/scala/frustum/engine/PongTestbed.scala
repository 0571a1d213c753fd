package frustum.engine

import frustum.blackbox.Tech
import frustum.boards.icebreaker.{IcebreakerTops, PongTop}
import frustum.peripheral.SimVideoMonitor
import frustum.pipelines.PongPipelineConfig
import spinal.core._
import spinal.core.sim._

/** The board's top with a monitor at its pins, and buttons, high when pressed. */
case class PongTestbed(config: PongPipelineConfig) extends Component {
  val io      = new Bundle { val up, down, left, right = in Bool () }
  val top     = PongTop(config, IcebreakerTops.pongMHz, Tech.Generic)
  val monitor = SimVideoMonitor(config.mode, config.format.bits)

  // Both sides run from one clock, which the top's clock tree hides from the check.
  top.io.flatten.foreach(_.addTag(crossClockDomain))
  top.io.clk             := ClockDomain.current.readClockWire
  top.io.up              := io.up
  top.io.down_n          := !io.down
  top.io.left            := io.left
  top.io.right           := io.right
  monitor.io.pins.hSync  := top.io.dvi_hSync
  monitor.io.pins.vSync  := top.io.dvi_vSync
  monitor.io.pins.active := top.io.dvi_de
  monitor.io.pins.color  := top.io.dvi_red ## top.io.dvi_green ## top.io.dvi_blue

  private val game = top.core.pipeline.game.io
  Seq(game.tens, game.ones, game.won).foreach(_.simPublic())

  def latencyClocks: Int = top.core.pipeline.latencyClocks
  def score: Int         = game.tens.toInt * 10 + game.ones.toInt
  def won: Boolean       = game.won.toBoolean
}
