package frustum.engine.voxel

import frustum.boards.icebreaker.VoxelTop
import frustum.contract.video.Panel
import frustum.contract.voxel.VoxelConfig
import frustum.device.Tech
import frustum.peripheral.SimTft
import spinal.core._
import spinal.core.sim._

/** `icebreaker-voxel` with a display at its pins. The display looks twice a clock of the core, whose two halves SCK
  * tells apart.
  */
case class CompactVoxelPins(c: VoxelConfig, focal: Int) extends Component {
  val io = new Bundle {
    val run = in Bool () // resetn
    val uart = in Bool ()
    val refused = out Bool ()
    val clocks = out(Reg(UInt(32 bits)) init 0) // of the core
  }
  val top = VoxelTop(
    c,
    CompactVoxelPins.Panel,
    focal,
    CompactVoxelPins.CoreMHz,
    Tech.Generic,
    CompactVoxelPins.Baud,
    CompactVoxelPins.Fast
  )
  val tft = SimTft(gapLog2 = 8)
  val half = RegInit(False)
  half := !half
  when(half)(io.clocks := io.clocks + 1)

  // All run from one clock, which the top's clock tree hides from the check.
  top.io.flatten.foreach(_.addTag(crossClockDomain))
  top.io.clk := half
  top.io.resetn := io.run
  top.io.uart := io.uart
  tft.io.pins := top.io.display
  io.refused := !top.io.refused_n
  top.core.console.pipeline.memory.ram.inferred.simPublic()
  top.core.console.host.io.refused.simPublic()
}

object CompactVoxelPins {
  val Panel: Panel = frustum.contract.video.Panel.St7789
  val CoreMHz = BigDecimal("28.125")

  /** An eighth of half of the core clock. */
  val Baud = 1757812

  /** By how much the display's pauses at its start are shortened. */
  val Fast = 4000
}
