package frustum.engine.pong

import frustum.demos.pong.PongPipelineConfig
import frustum.engine.{DirectClock, EngineSim, VideoSession}
import frustum.model.demos.pong.PongButtons
import frustum.peripheral.SimVideoReader
import spinal.core.sim._

/** Plays on a running [[PongTestbed]], frame by frame. To be made first thing in the simulation.
  *
  * Buttons are looked at in the blank before each frame, and what two looks agree on holds: pressed after an
  * even frame (counted from 0) and kept for two, they are those of one tick, the one before frame f + 3.
  *
  * @param first buttons at the start, of the tick before frame 1
  */
final class PongSession(dut: PongTestbed, first: PongButtons = PongButtons()) {
  press(first)
  private val clock = new DirectClock(dut.clockDomain)
  private val session = new VideoSession(dut.monitor)(clock.run)
  def reader: SimVideoReader = session.reader

  def press(b: PongButtons): Unit = {
    dut.io.up #= b.up
    dut.io.down #= b.down
    dut.io.left #= b.left
    dut.io.right #= b.right
  }

  /** The next frame's colours, as they were at the pins. */
  def frame(): Array[Int] = {
    session.frame()
    reader.picture()
  }
}

object PongSession {
  def compile(config: PongPipelineConfig, board: PongBoard): SimCompiled[PongTestbed] = {
    import config.{format, mode, scene}
    EngineSim.compile(s"${board.top}_${mode.hashCode.toHexString}_${format.name}_${scene.hashCode.toHexString}")(
      PongTestbed(config, board)
    )
  }
}
