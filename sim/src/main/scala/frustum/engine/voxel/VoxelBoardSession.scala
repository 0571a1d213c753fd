package frustum.engine.voxel

import frustum.demos.voxel.VoxelConsoleConfig
import frustum.engine.{EngineSim, VideoSession}
import frustum.peripheral.SimVideoReader
import spinal.core._
import spinal.core.sim._

/** A host and a monitor at the pins of a running [[VoxelBoardTestbed]]. To be made first thing in the simulation. */
final class VoxelBoardSession(dut: VoxelBoardTestbed) {
  import dut.config
  dut.io.uart #= true
  dut.io.pad.dat #= true
  dut.clockDomain.forkStimulus(EngineSim.Period)
  dut.clockDomain.waitSampling(10)
  private val session = new VideoSession(dut.monitor, config.divider)(EngineSim.clocks(dut.clockDomain))
  def reader: SimVideoReader = session.reader

  /** Puts the words of a world into its memory, by the simulator's back door: by the serial line it takes 21 seconds.
    */
  def load(words: Array[Int]): Unit =
    for ((w, i) <- words.zipWithIndex) dut.top.core.console.pipeline.memory.words.setBigInt(i.toLong, BigInt(w))

  def words(n: Int): Array[Int] =
    Array.tabulate(n)(i => dut.top.core.console.pipeline.memory.words.getBigInt(i.toLong).toInt)

  def send(bytes: Seq[Int]): Unit = {
    val bit = EngineSim.Period * VoxelBoardSession.ClockHz / config.baud
    for (byte <- bytes; level <- 0 +: (0 until 8).map(byte >> _ & 1) :+ 1) {
      dut.io.uart #= level == 1
      sleep(bit)
    }
  }
  def wait(micros: Int): Unit = sleep(EngineSim.Period * VoxelBoardSession.ClockHz / 1000000 * micros)

  /** The next whole frame, as it was at the pins. */
  def frame(): Array[Int] = {
    session.frame()
    reader.picture()
  }

  /** The picture of what the host has said by now: the one drawn at the time is shown first. */
  def settled(): Array[Int] = {
    val before = dut.io.pictures.toLong
    while (dut.io.pictures.toLong < before + 2) session.frame()
    session.frame()
    frame()
  }
  def clocks: Long = dut.io.clocks.toLong
  def steps: Long = dut.io.steps.toLong
}

object VoxelBoardSession {
  val ClockHz = 100000000L

  def compile(config: VoxelConsoleConfig): SimCompiled[VoxelBoardTestbed] =
    EngineSim.compile(
      s"VoxelBoard_${config.voxel.size}_${config.voxel.width}x${config.voxel.height}_${config.hashCode.toHexString}"
    )(VoxelBoardTestbed(config))
}
