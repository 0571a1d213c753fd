package frustum.command

import frustum.engine.PongRun
import frustum.game.{AutoPlayer, ButtonFile}
import frustum.judge.PongJudge
import frustum.model.game.{PongButtons, PongGame}
import frustum.picture.{AnimatedGif, Picture}
import frustum.pipelines.PongPipelineConfig
import frustum.{InputError, OutputFile}
import java.nio.file.{Files, Path}

/** `pong`: a game on the simulated board, each frame judged, as PNG files and one animated GIF. */
object PongCommand extends CommandLine {
  val name    = "pong"
  val summary = "plays ray-cast pong on the simulated hardware; writes frames and pong.gif to out/pong"

  def run(args: Seq[String]): Int =
    Arguments.parse(name, PongOptions.parser, args, PongOptions()).map(PongOptions.check).fold(0)(pong)

  /** A tick is two frames, a thirtieth of a second: hundredths that add up to it. */
  def delays: Iterator[Int] = Iterator.continually(Seq(3, 3, 4)).flatten

  private def pong(o: PongOptions): Int = {
    val config = PongPipelineConfig(mode = o.mode, scene = PongScenes(o.mode, o.scene))
    val player = players(o)
    prepare(o.out)
    println(s"pong: ${o.mode.name}, ${o.frames} frames")
    val judge    = new PongJudge(config)
    val run      = new PongRun(config, player, o.seed)
    val started  = System.nanoTime
    val progress = Progress(name, o.frames)
    val measures =
      try {
        var measured = Option.empty[frustum.engine.PongMeasures]
        AnimatedGif.write(o.out.resolve("pong.gif"), o.mode.width, o.mode.height) { gif =>
          val times = delays
          measured = Some(run.play(o.frames) { frame =>
            val picture = Picture.ofFormat(frame.atPins, config.format)
            Picture.writePng(o.out.resolve(f"frame-${frame.index}%04d.png"), o.mode.width, o.mode.height, picture)
            if (frame.index % 2 == 0) gif.add(picture, times.next())
            judge.add(frame)
            progress.step()
          })
        }
        measured.get
      } finally progress.close()
    val figures = judge.figures()
    val report  = PongReport.json(name, o.seed, config, measures, figures, (System.nanoTime - started) / 1e9)
    OutputFile.writeText(o.reportFile, ujson.write(report, indent = 2) + "\n")
    println(PongTable(report))
    println(s"wrote ${o.out.resolve("pong.gif")} and ${o.reportFile}")
    val failures = PongReport.failures(measures, figures)
    failures.foreach(f => Console.err.println(s"error: pong: $f; see ${o.reportFile}"))
    if (failures.isEmpty) 0 else 1
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
        throw InputError(s"--out $out cannot be made (${e.getClass.getSimpleName}): name a folder that can be written")
    }
    Option(out.toFile.listFiles).toSeq.flatten.filter(_.getName.matches("frame-\\d{4,}\\.png")).foreach(_.delete())
  }
}
