package frustum.command.pong

import frustum.boards.Tops
import frustum.command.common.{Arguments, CommandLine}
import frustum.contract.InputError
import frustum.demos.pong.PongPipelineConfig
import frustum.engine.pong.PongSession
import frustum.files.OutputFile
import frustum.model.demos.pong.{PongButtons, PongGame}
import frustum.picture.Picture
import frustum.play.{AutoPlayer, ButtonFile}
import frustum.ray.scene.RayConfig
import java.nio.file.{Files, Path}

/** `pong`: a game on the simulated board, each frame judged, as PNG files and one animated GIF. */
object PongCommand extends CommandLine {
  val name = "pong"
  val summary = "plays ray-cast pong on the simulated hardware; writes frames and pong.gif to out/pong"

  def run(args: Seq[String]): Int =
    Arguments.parse(name, PongOptions.parser, args, PongOptions()).map(PongOptions.check).fold(0)(pong)

  private def pong(o: PongOptions): Int = {
    val config = PongScenes.config(o.mode, o.scene)
    o.scene.foreach(build(config, o, _))
    val player = players(o)
    prepare(o.out)
    OutputFile.check(o.reportFile)
    println(s"pong: ${o.board.top}, ${o.mode.name}, ${o.frames} frames")
    val recording = PongRecording(config, player, o.seed, o.frames, o.out.resolve("pong.gif"), o.board, o.every) {
      (index, _, picture) =>
        Picture.writePng(o.out.resolve(f"frame-$index%04d.png"), o.mode.width, o.mode.height, picture)
    }
    val report = PongReport.json(name, o.seed, config, recording)
    println(PongTable(report))
    val code = PongReport.write(o.reportFile, report, recording)
    println(s"wrote ${o.out.resolve("pong.gif")} and ${o.reportFile}")
    code
  }

  /** Makes the hardware of a scene, whose numbers may need more bits, or its set-up more clocks, than there are. */
  private def build(config: PongPipelineConfig, o: PongOptions, scene: Path): Unit = {
    val part = Tops.find(o.board.top).get.part
    val need = config.scene.imageBits / 1024
    if (need > part.blockRamKbit)
      throw InputError(
        s"$scene: its images need $need kbit, the ${part.name} of ${o.board.top} has ${part.blockRamKbit} in its " +
          "block RAM; take smaller ones"
      )
    try {
      RayConfig(config.scene, config.mode) // its numbers are checked before any hardware is made
      PongSession.compile(config, o.board)
    } catch {
      case e: IllegalArgumentException =>
        throw InputError(s"$scene: ${e.getMessage.stripPrefix("requirement failed: ")}")
    }
  }

  private def players(o: PongOptions): PongGame => PongButtons = o.input match {
    case Some(file) =>
      val lines = ButtonFile.read(file).iterator
      _ => if (lines.hasNext) lines.next() else PongButtons()
    case None => if (o.autoplay) AutoPlayer(_) else _ => PongButtons()
  }

  /** A folder that can be written, without the frames of an earlier run. */
  private def prepare(out: Path): Unit = {
    try Files.createDirectories(out)
    catch {
      case e: java.io.IOException =>
        throw InputError(
          s"--out $out cannot be made (${e.getClass.getSimpleName}): name a folder that can be written"
        )
    }
    Option(
      out.toFile.listFiles
    ).toSeq.flatten.filter(_.getName.matches("frame-\\d{4,}\\.png")).foreach(_.delete())
  }
}
