package frustum.command

import frustum.InputError
import frustum.engine.{EngineSim, PongSession}
import frustum.game.PongKeys
import frustum.live.LiveScreen
import frustum.picture.Picture
import frustum.spec.VideoMode
import scopt.OParser
import java.util.Locale

/** Arguments of `play`. */
final case class PlayOptions(
    what: String = "",
    mode: VideoMode = VideoMode.Vga640x480,
    frames: Option[Int] = None,
    seed: Long = 1
)

/** `play pong`: the simulated hardware's screen in a window, with the keys as its buttons. */
object PlayCommand extends CommandLine {
  val name    = "play"
  val summary = "shows a system's simulated screen in a window and takes keys: play pong"

  private val parser: OParser[_, PlayOptions] = {
    val builder = OParser.builder[PlayOptions]
    import builder._
    OParser.sequence(
      programName("./sbt play"),
      head(s"play: $summary"),
      arg[String]("pong").optional().action((v, o) => o.copy(what = v)).text("what to play: pong"),
      opt[VideoMode]("mode")(
        Arguments.oneOf(PongOptions.modes: _*)
      ).valueName(PongOptions.modes.map(_._1).mkString("|"))
        .action((v, o) => o.copy(mode = v)).text(s"(default ${PongOptions.modes.head._1})"),
      opt[Int]("frames")(Arguments.count).valueName("N").action((v, o) => o.copy(frames = Some(v)))
        .text("ends after so many (default: when the window is closed)"),
      opt[Long]("seed")(Arguments.seed).valueName("N").action((v, o) => o.copy(seed = v))
        .text("of whatever is random at the start of the simulation (default 1)"),
      note(s"  --help                   prints this\n\n${PongKeys.help}")
    )
  }

  def run(args: Seq[String]): Int = Arguments.parse(name, parser, args, PlayOptions()).fold(0) { o =>
    if (o.what != "pong") throw InputError(s"argument: there is no '${o.what}' to play; write play pong")
    play(o)
  }

  private def play(o: PlayOptions): Int = {
    val config = PongScenes.config(o.mode, None)
    LiveScreen.require()
    println(PongKeys.help)
    EngineSim.run(PongSession.compile(config), None, o.seed) { dut =>
      val session = new PongSession(dut)
      val screen  = LiveScreen("Frustum: pong", o.mode.width, o.mode.height)
      try {
        val keys    = new PongKeys
        val started = System.nanoTime
        var shown   = 0
        while (screen.isOpen && o.frames.forall(shown < _)) {
          val picture = Picture.ofFormat(session.frame(), config.format)
          session.press(keys(screen.keys()))
          screen.show(picture, s"score ${dut.score}")
          shown += 1
        }
        val rate = shown * 1e9 / (System.nanoTime - started)
        println(s"$shown frames, ${"%.1f".formatLocal(Locale.ROOT, rate)} a second, score ${dut.score}")
        if (session.reader.errors == 0) 0
        else {
          Console.err.println(
            s"error: play pong: ${session.reader.errors} sync errors; ./sbt \"pong\" tells which"
          )
          1
        }
      } finally screen.close()
    }
  }
}
