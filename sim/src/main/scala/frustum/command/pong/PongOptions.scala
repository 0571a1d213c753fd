package frustum.command.pong

import frustum.command.common.Arguments
import frustum.contract.InputError
import frustum.contract.video.VideoMode
import frustum.engine.pong.PongBoard
import scopt.OParser
import java.nio.file.{Path, Paths}

/** Arguments of `pong`. */
final case class PongOptions(
    frames: Int = 60,
    every: Int = 1,
    autoplay: Boolean = false,
    input: Option[Path] = None,
    scene: Option[Path] = None,
    mode: VideoMode = VideoMode.Vga640x480,
    board: PongBoard = PongBoard.all.head,
    out: Path = Paths.get("out", "pong"),
    report: Option[Path] = None,
    seed: Long = 1
) {
  def reportFile: Path = report.getOrElse(out.resolve("pong.json"))
}

object PongOptions {
  val modes: Seq[(String, VideoMode)] = Seq(VideoMode.Vga640x480, VideoMode.Svga800x600).map(m => m.name -> m)

  val parser: OParser[_, PongOptions] = {
    val builder = OParser.builder[PongOptions]
    import builder._
    OParser.sequence(
      programName("./sbt pong"),
      head(s"pong: ${PongCommand.summary}"),
      opt[Int]("frames")(Arguments.count).valueName("N").action((v, o) => o.copy(frames = v))
        .text("frames to draw (default 60)"),
      opt[Int]("every")(Arguments.count).valueName("N").action((v, o) => o.copy(every = v))
        .text("judges, writes and films one frame of so many, for long games (default 1: all)"),
      opt[Unit]("autoplay").action((_, o) => o.copy(autoplay = true))
        .text("the paddle goes where the puck will arrive (default: no button is pressed)"),
      opt[Path]("input")(Arguments.file).valueName("FILE").action((v, o) => o.copy(input = Some(v)))
        .text("buttons, a line a tick of two frames: any of u d l r, or -"),
      opt[Path]("scene")(Arguments.file).valueName("FILE.json").action((v, o) => o.copy(scene = Some(v)))
        .text("what is drawn (default: the room of pong)"),
      opt[VideoMode]("mode")(Arguments.oneOf(modes: _*)).valueName(modes.map(_._1).mkString("|"))
        .action((v, o) => o.copy(mode = v)).text(s"(default ${modes.head._1})"),
      opt[PongBoard]("top")(Arguments.oneOf(PongBoard.all.map(b => b.top -> b): _*))
        .valueName(PongBoard.all.map(_.top).mkString("|")).action((v, o) => o.copy(board = v))
        .text(s"what is simulated (default ${PongBoard.all.head.top})"),
      opt[Path]("out")(Arguments.file).valueName("DIR").action((v, o) => o.copy(out = v))
        .text("for frame-0000.png and so on, and pong.gif (default out/pong)"),
      opt[Path]("report")(Arguments.file).valueName("FILE.json").action((v, o) => o.copy(report = Some(v)))
        .text("(default pong.json in the folder of --out)"),
      opt[Long]("seed")(Arguments.seed).valueName("N").action((v, o) => o.copy(seed = v))
        .text("of whatever is random at the start of the simulation (default 1)"),
      note("  --help                   prints this")
    )
  }

  def check(o: PongOptions): PongOptions = {
    if (o.autoplay && o.input.isDefined)
      throw InputError("--autoplay and --input: both press the buttons; give one of them")
    o
  }
}
