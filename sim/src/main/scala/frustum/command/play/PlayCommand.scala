package frustum.command.play

import frustum.command.common.{Arguments, CommandLine}
import frustum.command.pong.{PongOptions, PongScenes}
import frustum.command.voxel.{VoxelOptions, VoxelScenes}
import frustum.contract.InputError
import frustum.contract.video.VideoMode
import frustum.engine.pong.{PongBoard, PongEngines, PongSession, PongSetting}
import frustum.picture.Picture
import frustum.play.{LiveScreen, PongKeys, VoxelKeys}
import scopt.OParser
import java.nio.file.Path
import java.util.Locale

/** Arguments of `play`. */
final case class PlayOptions(
    what: String = "",
    mode: VideoMode = VideoMode.Vga640x480,
    frames: Option[Int] = None,
    seed: Long = 1,
    voxel: VoxelOptions = VoxelOptions(size = (160, 120)),
    hardware: Boolean = true,
    fly: Boolean = false
)

/** `play pong`, `play voxel`: the simulated hardware's screen in a window, with the keys as its buttons. */
object PlayCommand extends CommandLine {
  val name = "play"
  val summary = "shows a system's simulated screen in a window and takes keys: play pong, play voxel"

  private val parser: OParser[_, PlayOptions] = {
    val builder = OParser.builder[PlayOptions]
    import builder._
    OParser.sequence(
      programName("./sbt play"),
      head(s"play: $summary"),
      arg[String]("pong|voxel").optional().action((v, o) => o.copy(what = v)).text("what to play"),
      opt[VideoMode]("mode")(
        Arguments.oneOf(PongOptions.modes: _*)
      ).valueName(PongOptions.modes.map(_._1).mkString("|"))
        .action((v, o) => o.copy(mode = v)).text(s"pong's (default ${PongOptions.modes.head._1})"),
      opt[Path]("world")(Arguments.file).valueName("FILE").action((v, o) =>
        o.copy(voxel = o.voxel.copy(world = Some(v)))
      )
        .text("voxel's: raw ids of 64x64x32 blocks, or MagicaVoxel .vox (default: hills from --seed)"),
      opt[(Int, Int, Int)]("crop")(VoxelOptions.crop).valueName("x,y,z")
        .action((v, o) => o.copy(voxel = o.voxel.copy(crop = Some(v))))
        .text("voxel's: takes the part of a .vox scene from this voxel on (default: the whole scene)"),
      opt[Unit]("opaque").action((_, o) => o.copy(voxel = o.voxel.copy(opaque = true)))
        .text("voxel's: glass of a .vox scene is solid (default: see-through)"),
      opt[(Int, Int)]("size")(Arguments.size).valueName("WxH").action((v, o) => o.copy(voxel = o.voxel.copy(size = v)))
        .text("voxel's, pixels (default 160x120)"),
      opt[Boolean]("engine")(Arguments.oneOf("hardware" -> true, "model" -> false)).valueName("hardware|model")
        .action((v, o) => o.copy(hardware = v)).text("what draws voxel (default hardware)"),
      opt[Unit]("fly").action((_, o) => o.copy(fly = true)).text("voxel: without gravity"),
      opt[Int]("frames")(Arguments.count).valueName("N").action((v, o) => o.copy(frames = Some(v)))
        .text("ends after so many (default: when the window is closed)"),
      opt[Long]("seed")(Arguments.seed).valueName("N").action((v, o) => o.copy(seed = v))
        .text("of whatever is random at the start of the simulation, and of the hills (default 1)"),
      note(s"  --help                   prints this\n\npong: ${PongKeys.help}\nvoxel: ${VoxelKeys.help}")
    )
  }

  def run(args: Seq[String]): Int = Arguments.parse(name, parser, args, PlayOptions()).fold(0) { o =>
    o.what match {
      case "pong"  => play(o)
      case "voxel" =>
        PlayVoxel(VoxelScenes(o.voxel.copy(seed = o.seed)), o.hardware, o.fly, o.frames, o.seed)
      case other => throw InputError(s"argument: there is no '$other' to play; write play pong or play voxel")
    }
  }

  private def play(o: PlayOptions): Int = {
    val config = PongScenes.config(o.mode, None)
    LiveScreen.require()
    println(PongKeys.help)
    PongSession.compile(config, PongBoard.Icebreaker) // before the window opens, and not in the rate
    val screen = LiveScreen("Frustum: pong", o.mode.width, o.mode.height)
    try {
      val keys = new PongKeys
      val started = System.nanoTime
      var (shown, score, syncErrors) = (0, 0, 0L)
      val pressed = Iterator.continually(()).takeWhile(_ => screen.isOpen && o.frames.forall(shown < _))
        .map(_ => keys(screen.keys()))
      PongEngines.default.make(PongSetting(config, PongBoard.Icebreaker, o.seed)).draw(pressed) { frame =>
        score = frame.measures.score
        syncErrors = frame.measures.syncErrors
        screen.show(Picture.ofFormat(frame.atPins, config.format), s"score $score")
        shown += 1
      }
      val rate = shown * 1e9 / (System.nanoTime - started)
      println(s"$shown frames, ${"%.1f".formatLocal(Locale.ROOT, rate)} a second, score $score")
      if (syncErrors > 0)
        Console.err.println(s"error: play pong: $syncErrors sync errors; ./sbt \"pong\" tells which")
      if (syncErrors > 0) 1 else 0
    } finally screen.close()
  }
}
