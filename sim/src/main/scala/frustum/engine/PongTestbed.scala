package frustum.engine

import frustum.peripheral.SimVideoMonitor
import frustum.pipelines.{PongPipeline, PongPipelineConfig}
import spinal.core._
import spinal.core.sim._

/** Pong with a monitor at its pins, and buttons. */
case class PongTestbed(config: PongPipelineConfig) extends Component {
  val io      = new Bundle { val up, down, left, right = in Bool () }
  val top     = PongPipeline(config)
  val monitor = SimVideoMonitor(config.mode, config.format.bits)
  top.io.buttons.up         := io.up
  top.io.buttons.down       := io.down
  top.io.buttons.left       := io.left
  top.io.buttons.right      := io.right
  monitor.io.pins.hSync     := top.io.video.hSync
  monitor.io.pins.vSync     := top.io.video.vSync
  monitor.io.pins.active    := top.io.video.active
  monitor.io.pins.color     := top.io.video.red ## top.io.video.green ## top.io.video.blue
  private val game           = top.game.io
  Seq(game.tens, game.ones, game.won).foreach(_.simPublic())

  def latencyClocks: Int = top.latencyClocks
  def score: Int         = game.tens.toInt * 10 + game.ones.toInt
  def won: Boolean       = game.won.toBoolean
}
