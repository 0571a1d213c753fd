package frustum.engine

import frustum.blackbox.Tech
import frustum.peripheral.SimVideoMonitor
import frustum.pipelines.VoxelConsole
import frustum.spec.{ColorFormat, VideoMode, VoxelAssets, VoxelCamera, VoxelConfig}
import spinal.core._
import spinal.core.sim._

/** The console with a monitor at its plug. */
case class VoxelConsoleTestbed(
    c: VoxelConfig,
    assets: VoxelAssets,
    mode: VideoMode,
    camera: VoxelCamera,
    baud: Int
) extends Component {
  val io = new Bundle {
    val uart    = in Bool ()
    val refused = out UInt (8 bits)
  }
  val console = VoxelConsole(c, assets, camera, Tech.Generic, mode, ColorFormat.Rgb444, baud = baud)
  console.io.uart := io.uart
  io.refused      := console.io.refused
  private val slow = new SlowArea(4) {
    val monitor = SimVideoMonitor(mode, ColorFormat.Rgb444.bits)
    val video   = console.io.video
    monitor.io.pins.hSync  := video.hSync
    monitor.io.pins.vSync  := video.vSync
    monitor.io.pins.active := video.active
    monitor.io.pins.color  := video.red ## video.green ## video.blue
  }
  def monitor: SimVideoMonitor = slow.monitor
  console.pipeline.memory.words.simPublic()
}
