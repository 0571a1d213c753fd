package frustum.demos.voxel

import frustum.contract.video.Font
import frustum.contract.voxel.VoxelHostCommand
import frustum.demos.pad.{ConsolePad, ConsolePadPins}
import frustum.device.Tech
import frustum.video.{DoubleFrameBuffer, DoubledScanout, VideoBus}
import frustum.voxel.VoxelPipeline
import frustum.voxel.world.WorldEditor
import spinal.core._
import spinal.lib._
import spinal.lib.com.uart.{UartCtrl, UartCtrlInitConfig, UartParityType, UartStopType}

/** A world of blocks on a monitor, with a console's pad to walk in it. The picture is drawn into one frame buffer while
  * the other is shown; they are exchanged in the vertical blank alone. Then the player moves, is drawn, and the pad is
  * polled again. World and camera change between pictures alone. A host may send the world, blocks, a place for the
  * player or, instead of the player's view, a camera, over a serial line. All of it runs from one clock; the monitor's
  * side is enabled in one of `divider` cycles.
  */
case class VoxelConsole(config: VoxelConsoleConfig, tech: Tech = Tech.Generic) extends Component {
  import config.{assets, format, mode, rules}
  private val voxel = config.voxel
  val io = new Bundle {
    val uart = in Bool ()
    val pad = master(ConsolePadPins())
    val video = master(VideoBus(format))
    val refused = out UInt (8 bits) // refused commands of the host
  }
  val uart = UartCtrl(UartCtrlInitConfig(config.baud, 7, UartParityType.NONE, UartStopType.ONE), readonly = true)
  val clockMHz = ClockDomain.current.frequency.getValue.toDouble / 1e6

  /** The receiver samples eight times per bit. */
  val looks = clockMHz * 1e6 / config.baud / 8
  require(
    (looks / looks.floor - 1).abs < 0.01,
    s"${config.baud} baud at $clockMHz MHz: $looks cycles from sample to sample are not near an integer"
  )
  val host = VoxelHost(voxel, rules, silence = (clockMHz * VoxelHostCommand.SilenceMicros).toInt)
  val pad = ConsolePad((clockMHz * 1e6).toLong)
  val player = VoxelPlayer(voxel, rules, assets.table, config.program, config.start)
  val pipeline = VoxelPipeline(voxel, assets.table, assets.textures, tech)
  val editor = WorldEditor(voxel)
  val frames = DoubleFrameBuffer(voxel.pixels, format.bits)
  val scan = new SlowArea(config.divider) {
    val out = DoubledScanout(mode, format, config.scale, Seq(config.readout.rate, config.readout.item))
  }.out
  val starts = scan.io.blank.rise(False)
  val blank = RegNext(starts, False)
  val editing = RegInit(False) // an edit of the host is in progress

  /** A picture is drawn from one blank to, at the latest, the next but one. */
  val turn = new Area {
    val drawn, waiting, playing = RegInit(False)
    val byHost, highlight = RegInit(False) // whose camera it is, and what else the host requests
    val swap = blank && drawn && !pipeline.io.busy && !playing
    val go = waiting && !editing
    waiting setWhen (blank && !pipeline.io.busy && !playing) clearWhen go
    playing setWhen (go && !byHost) clearWhen player.io.done
    player.io.frame := go && !byHost
    pipeline.io.start := go && byHost || player.io.done
    drawn clearWhen swap setWhen pipeline.io.start
    frames.io.swap := swap

    when(host.io.camera.valid) {
      byHost := True
      highlight := host.io.highlight
    }
    byHost clearWhen (host.io.pose.valid || pad.io.state.start)
  }

  pad.io.pins <> io.pad
  pad.io.poll := blank
  player.io.buttons := VoxelButtons.of(pad.io.state)
  player.io.pointedAt := pipeline.io.pointedAt
  player.io.place << host.io.pose
  player.io.load << host.io.camera
  pipeline.io.camera := player.io.camera
  pipeline.io.highlight := RegNextWhen(!turn.byHost || turn.highlight, pipeline.io.start, False)

  uart.io.uart.rxd := io.uart
  // What passes comes to the host a cycle later, and what it does a cycle after that, so halting begins two cycles
  // before the update. Only an edit that waits stalls a byte for longer, and then it is the first one of a command and
  // changes nothing.
  uart.io.read.queue(
    VoxelConsole.Bytes
  ).haltWhen(turn.playing || turn.waiting || starts || blank).m2sPipe() >> host.io.bytes
  io.refused := host.io.refused

  /** Edits, one at a time: the host's between pictures, the player's when it is updated. The one that is busy reads the
    * memory.
    */
  val change = new Area {
    val edit = host.io.edit.queue(VoxelConsole.Edits)
    val free = !pipeline.io.busy && !turn.playing && !turn.waiting
    editing setWhen (edit.valid && edit.byId && free) clearWhen editor.io.edit.ready
    edit.ready := !turn.playing && editor.io.edit.ready || !edit.byId && free && !editing

    editor.io.edit.valid := editing || player.io.edit.valid
    editor.io.edit.address := Mux(editing, edit.address, player.io.edit.address)
    editor.io.edit.id := Mux(editing, edit.content(4 downto 0).asUInt, player.io.edit.id)
    player.io.edit.ready := turn.playing && editor.io.edit.ready

    val raw = edit.valid && !edit.byId && free && !editing
    pipeline.io.edit.valid := editor.io.write.valid || raw
    pipeline.io.edit.address := Mux(raw, edit.address, editor.io.write.address)
    pipeline.io.edit.word := Mux(raw, edit.content, editor.io.write.word)
    pipeline.io.look.address := Mux(player.io.edit.valid || editing, editor.io.read.address, player.io.read.address)
    editor.io.read.word := pipeline.io.look.word
    player.io.read.word := pipeline.io.look.word
  }

  frames.io.address := scan.io.address
  scan.io.color := frames.io.color
  io.video <> scan.io.video

  /** Colours as the pins have them. */
  val written = new Area {
    val pixel = RegNext(pipeline.io.pixels.payload)
    private def pins(v: UInt, n: Int) =
      if (config.color.gamma == 1) v(7 downto 8 - n)
      else Vec((0 to 255).map(i => U(config.color.channel(i, n), n bits)))(v)
    frames.io.write.valid := RegNext(pipeline.io.pixels.valid, False)
    frames.io.write.address := pixel.pixel.resized
    frames.io.write.color := Cat(format.channels.zipWithIndex.reverse.map { case (n, i) => pins(pixel.rgb(i), n) })
  }

  /** Pictures of the last second, two digits. */
  val rate = new Area {
    val second = Counter(VoxelReadout.Second, blank)
    val tens, ones = Reg(UInt(4 bits)) init 0
    when(turn.swap) {
      ones := ones + 1
      when(ones === 9) {
        ones := 0
        tens := tens + 1
      }
    }
    when(second.willOverflow) {
      tens := 0
      ones := turn.swap.asUInt.resized
    }
    val shown = RegNextWhen(tens ## ones, second.willOverflow) init 0
  }

  /** The text over a picture is shown with it, unless the camera is the host's. */
  val marks = new Area {
    val mine = RegNextWhen(!turn.byHost, pipeline.io.start, False)
    val item = RegNextWhen(RegNextWhen(player.io.item, pipeline.io.start), turn.swap) init 0
    val length = config.readout.item.length
    val names = Mem(
      Bits(length * Font.CodeBits bits),
      (0 until 1 << item.getWidth).map { id =>
        val name = if (assets.table.ids.contains(id)) config.readout.name(id) else " " * length
        B(
          name.zipWithIndex.map { case (letter, i) => BigInt(Font.code(letter)) << i * Font.CodeBits }.sum,
          length * Font.CodeBits bits
        )
      }
    )
    private def digit(d: UInt) = U(Font.code('0'), Font.CodeBits bits) | d.resized
    scan.io.marked := RegNextWhen(mine, turn.swap, False)
    scan.io.text(0) := Vec(rate.shown.subdivideIn(4 bits).reverse.map(d => digit(d.asUInt)))
    scan.io.text(1).assignFromBits(names.readSync(item))
  }
}

object VoxelConsole {

  /** Edits that wait while a picture is drawn; further ones are lost and counted as refused. */
  val Edits = 512

  /** Bytes that wait until the player is updated. */
  val Bytes = 64
}
