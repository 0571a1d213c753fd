package frustum.demos.voxel

import frustum.contract.video.{Panel, WholeScreen}
import frustum.contract.voxel.{VoxelAssets, VoxelCamera, VoxelConfig, VoxelHostCommand}
import frustum.device.Tech
import frustum.video.{DisplayPins, SpiDisplay}
import frustum.voxel.CompactVoxelPipeline
import spinal.core._
import spinal.lib._
import spinal.lib.com.uart.{UartCtrl, UartCtrlInitConfig, UartParityType, UartStopType}

/** A world of blocks on a serial display: a host sends world and camera over a serial line, frame after frame goes to
  * the display pixel by pixel as it is drawn. A frame is of one camera, and of one world unless one is being loaded.
  *
  * @param camera initial camera
  * @param clocksPerBit of the display's SCK
  * @param fast   shortens the display's pauses, for simulation
  */
case class CompactVoxelConsole(
    config: VoxelConfig,
    assets: VoxelAssets,
    camera: VoxelCamera,
    panel: Panel,
    tech: Tech = Tech.Generic,
    baud: Int = 500000,
    clocksPerBit: Int = 1,
    fast: Int = 1
) extends Component {
  val io = new Bundle {
    val uart = in Bool ()
    val display = out(DisplayPins())
    val refused = out UInt (8 bits) // refused commands of the host
  }
  private val clockHz = ClockDomain.current.frequency.getValue.toLong
  val screen = WholeScreen(config.width, config.height)
  val uart = UartCtrl(UartCtrlInitConfig(baud, 7, UartParityType.NONE, UartStopType.ONE), readonly = true)
  val host = CompactHost(config, silence = (clockHz * VoxelHostCommand.SilenceMicros / 1000000).toInt)
  val pipeline = CompactVoxelPipeline(config, assets, camera, tech)
  val display = SpiDisplay(screen, panel, clockHz, clocksPerBit, fast, tech)

  /** The receiver samples eight times per bit. */
  val looks = clockHz.toDouble / baud / 8
  require(
    (looks / looks.floor - 1).abs < 0.01,
    s"$baud baud at $clockHz Hz: $looks cycles from sample to sample are not near an integer"
  )
  uart.io.uart.rxd := io.uart
  uart.io.read >> host.io.bytes
  host.io.edit >> pipeline.io.edit
  host.io.camera >> pipeline.io.camera
  pipeline.io.commit := host.io.commit
  pipeline.io.start := !pipeline.io.edit.valid && !pipeline.io.pending

  /** The face in the middle is highlighted or not with the newest camera, and with the one that is drawn with. */
  val highlight = new Area {
    val newest, shown = RegInit(True)

    when(host.io.commit)(newest := host.io.highlight)
    when(pipeline.io.start && !pipeline.io.busy)(shown := newest)
    pipeline.io.highlight := shown
  }
  io.refused := host.io.refused
  io.display := display.io.pins

  /** Pixels in flight to the display: the first of each frame begins its window. */
  val scan = new Area {
    val left = Reg(UInt(config.pixelBits bits)) init 0 // remaining pixels of the frame
    val first = left === 0
    when(pipeline.io.pixels.fire)(left := Mux(first, U(config.pixels - 1), left - 1))
    display.io.pixels.arbitrationFrom(pipeline.io.pixels)
    display.io.pixels.color := pipeline.io.pixels.payload
    display.io.pixels.first := first
    display.io.pixels.tileX := 0
    display.io.pixels.tileY := 0
  }
}
