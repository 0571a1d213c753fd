package frustum.engine.voxel

import frustum.boards.arty.VoxelTop
import frustum.demos.pad.ConsolePadPins
import frustum.demos.voxel.VoxelConsoleConfig
import frustum.device.Tech
import frustum.peripheral.SimVideoMonitor
import spinal.core._
import spinal.core.sim._
import spinal.lib._

/** The Arty's voxel top with a monitor at its pins, and counters of what it does inside, so that the JVM need not be
  * woken.
  */
case class VoxelBoardTestbed(config: VoxelConsoleConfig) extends Component {
  val io = new Bundle {
    val uart = in Bool ()
    val pad = master(ConsolePadPins())
    val refused = out UInt (4 bits)
    val pictures = out(Reg(UInt(32 bits)) init 0) // shown so far
    val clocks, steps = out(Reg(UInt(32 bits)) init 0) // of the picture that was drawn last
  }
  val top = VoxelTop(config, Tech.Generic)
  // Both sides run from one clock, which the top's clock tree hides from the check.
  top.io.flatten.foreach(_.addTag(crossClockDomain))
  top.io.clk := ClockDomain.current.readClockWire
  top.io.resetn := !ClockDomain.current.readResetWire
  top.io.uart := io.uart
  top.io.pad_dat := io.pad.dat
  io.pad.att := top.io.pad_att
  io.pad.sck := top.io.pad_sck
  io.pad.cmd := top.io.pad_cmd
  io.refused := top.io.refused

  private val slow = new SlowArea(config.divider) {
    val monitor = SimVideoMonitor(config.mode, config.format.bits)
    monitor.io.pins.hSync := top.io.vga_hSync
    monitor.io.pins.vSync := top.io.vga_vSync
    monitor.io.pins.active := top.core.console.io.video.active.pull().addTag(crossClockDomain)
    monitor.io.pins.color := top.io.vga_red ## top.io.vga_green ## top.io.vga_blue
  }
  def monitor: SimVideoMonitor = slow.monitor

  val inside = new Area {
    private def look(b: Bool) = b.pull().addTag(crossClockDomain)
    val busy = look(top.core.console.pipeline.io.busy)
    val step = look(top.core.console.pipeline.io.step)
    val swap = look(top.core.console.frames.io.swap)
    val clocks, steps = Reg(UInt(32 bits)) init 0
    when(swap)(io.pictures := io.pictures + 1)
    when(busy) {
      clocks := clocks + 1
      steps := steps + step.asUInt
    }
    when(busy.fall(False)) {
      io.clocks := clocks
      io.steps := steps
      clocks := 0
      steps := 0
    }
  }

  /** The player's turns, for those who follow them. */
  val player = top.core.console.player
  (player.io.frame +: player.io.buttons.flatten).foreach(_.simPublic())
  private val pictures = top.core.console.rate.shown.simPublic()
  top.core.console.pipeline.memory.words.simPublic()

  /** Pictures a second, as the read-out has them. */
  def rate: Int = pictures.toInt / 16 * 10 + pictures.toInt % 16
}
