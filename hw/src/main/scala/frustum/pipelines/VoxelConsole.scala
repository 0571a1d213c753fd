package frustum.pipelines

import frustum.blackbox.Tech
import frustum.display.VideoBus
import frustum.frame.{DoubleFrameBuffer, DoubledScanout}
import frustum.spec.{ColorFormat, VideoMode, VoxelAssets, VoxelCamera, VoxelConfig, VoxelHostCommand}
import frustum.voxel.{VoxelHost, VoxelColor}
import spinal.core._
import spinal.lib._
import spinal.lib.com.uart.{UartCtrl, UartCtrlInitConfig, UartParityType, UartStopType}

/** A world of blocks on a monitor: a host sends world and camera over a serial line, the picture is drawn into one frame buffer while the other
  * is shown, each of its pixels four times. Pictures are exchanged in the vertical blank alone; world and camera
  * change between pictures alone. All runs from one clock; the monitor's side is enabled in one of `divider` clocks.
  *
  * @param camera the one of the start
  */
case class VoxelConsole(
    c: VoxelConfig,
    assets: VoxelAssets,
    camera: VoxelCamera,
    tech: Tech,
    mode: VideoMode = VideoMode.Vga640x480,
    format: ColorFormat = ColorFormat.Rgb444,
    divider: Int = 4,
    baud: Int = 500000
) extends Component {
  require(
    mode.width == 2 * c.width && mode.height == 2 * c.height,
    s"a picture of ${c.width} x ${c.height} is not half of ${mode.name}"
  )
  require(divider >= 4, s"a monitor's pixel every $divider clocks; a frame buffer's answer takes 3")
  val io = new Bundle {
    val uart    = in Bool ()
    val video   = master(VideoBus(format))
    val refused = out UInt (8 bits) // commands of the host
  }
  val uart     = UartCtrl(UartCtrlInitConfig(baud, 7, UartParityType.NONE, UartStopType.ONE), readonly = true)
  val clockMHz = ClockDomain.current.frequency.getValue.toDouble / 1e6

  /** The receiver looks eight times a bit. */
  val looks = clockMHz * 1e6 / baud / 8
  require(
    (looks / looks.floor - 1).abs < 0.01,
    s"$baud baud at $clockMHz MHz: $looks clocks from look to look are not near a whole number"
  )
  val host     = VoxelHost(c, camera, silence = (clockMHz * VoxelHostCommand.SilenceMicros).toInt)
  val pipeline = VoxelPipeline(c, assets.table, assets.textures, tech)
  val frames   = DoubleFrameBuffer(c.pixels, format.bits)
  val scan     = new SlowArea(divider) {
    val out = DoubledScanout(mode, format)
  }.out

  uart.io.uart.rxd := io.uart
  uart.io.read >> host.io.bytes
  host.io.edit.queue(VoxelConsole.Edits) >> pipeline.io.edit
  io.refused            := host.io.refused
  pipeline.io.camera    := host.io.camera
  pipeline.io.highlight := True

  frames.io.address := scan.io.address
  scan.io.color     := frames.io.color
  io.video <> scan.io.video

  /** Colours as the pins have them, each channel cut. */
  val written = new Area {
    val pixel = pipeline.io.pixels
    frames.io.write.valid   := pixel.valid
    frames.io.write.address := pixel.pixel.resized
    frames.io.write.color   := Cat(format.channels.zipWithIndex.reverse.map { case (bits, i) =>
      pixel.rgb(i)(7 downto 8 - bits)
    })
  }

  /** A picture is drawn from one blank to, at the latest, the next but one; edits have the time between. */
  val turn = new Area {
    val blank = scan.io.blank.rise(False)
    val drawn = RegInit(False)
    val swap  = blank && drawn && !pipeline.io.busy
    frames.io.swap    := swap
    pipeline.io.start := RegNext(blank && !pipeline.io.busy && !pipeline.io.edit.valid, False)
    drawn clearWhen swap setWhen pipeline.io.start
  }
}

object VoxelConsole {

  /** Edits that wait while a picture is drawn; what comes when all are taken is lost and counted as refused. */
  val Edits = 512
}
