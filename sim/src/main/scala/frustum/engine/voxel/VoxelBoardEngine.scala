package frustum.engine.voxel

import frustum.contract.InputError
import frustum.contract.video.{ColorFormat, PinColor, VideoMode}
import frustum.contract.voxel.{VoxelAssets, VoxelConfig, VoxelHostCommand}
import frustum.demos.voxel.VoxelConsoleConfig
import frustum.driver.voxel.VoxelView
import frustum.engine.EngineSim
import frustum.model.demos.voxel.VoxelScreen
import frustum.picture.Picture

/** arty-voxel at its pins: a host sends the camera, a monitor shows the picture. The monitor has several pixels for
  * each of the picture's: they are as many pictures of the view, with the colours of the pins, of four bits a channel.
  */
final class VoxelBoardEngine(setting: VoxelSetting) extends VoxelEngine {
  import setting.{config, highlight}
  private val board = VoxelBoardEngine.console(config, setting.assets)

  override def expected(model: Array[Int]): Seq[Array[Int]] =
    pictures(VoxelScreen(board).monitor(model.map(VoxelBoardEngine.Color(_)), None))

  def draw(views: Iterator[VoxelView])(each: RenderedView => Unit): Unit =
    EngineSim.run(VoxelBoardSession.compile(board), None, setting.seed) { dut =>
      val session = new VoxelBoardSession(dut)
      session.load(setting.model.words)
      for (view <- views) {
        val camera = view.camera(config)
        session.send(if (highlight) VoxelHostCommand.highlight(camera) else VoxelHostCommand.camera(camera))
        val shown = session.settled()
        if (session.reader.errors > 0)
          throw new IllegalStateException(s"${session.reader.errors} sync errors at the monitor")
        each(RenderedView(pictures(shown), Some(session.clocks)))
      }
    }

  private def pictures(monitor: Array[Int]): Seq[Array[Int]] = {
    val enlarged = 1 << board.scale
    for (dy <- 0 until enlarged; dx <- 0 until enlarged) yield {
      val pins = Array.tabulate(config.pixels) { n =>
        val (x, y) = (n % config.width * enlarged + dx, n / config.width * enlarged + dy)
        monitor(y * board.mode.width + x)
      }
      Picture.ofFormat(pins, VoxelBoardEngine.Color.format)
    }
  }
}

object VoxelBoardEngine {

  /** Of the board's pins. */
  val Color: PinColor = PinColor(ColorFormat.Rgb444)

  /** The Arty's console for pictures of any size: its monitor has twice as many pixels each way. */
  def console(c: VoxelConfig, assets: VoxelAssets): VoxelConsoleConfig = {
    def refuse(why: String): Nothing =
      throw InputError(s"--size ${c.width}x${c.height}: $why; change it or take --engine pipeline")
    val vga = VideoMode.Vga640x480
    val mode = vga.copy(name = s"${2 * c.width}x${2 * c.height}", width = 2 * c.width, height = 2 * c.height)
    if (c.pixels % 8 != 0 || c.width < 48)
      refuse("a board's monitor takes pictures at least 48 wide, of a multiple of 8 pixels")
    val whole = mode.width == vga.width && mode.height == vga.height
    try VoxelConsoleConfig(c, assets, if (whole) vga else mode).copy(color = Color)
    catch { case e: IllegalArgumentException => refuse(e.getMessage.stripPrefix("requirement failed: ")) }
  }
}
