package frustum.command.play

import frustum.command.common.{Arguments, CommandLine}
import frustum.command.pong.PongOptions
import frustum.command.voxel.VoxelOptions
import frustum.contract.InputError
import frustum.contract.video.VideoMode
import frustum.play.{PongKeys, RasterView, VoxelKeys}
import frustum.scene.Scenes
import scopt.OParser
import java.nio.file.Path
import java.util.Locale

/** `play pong`, `play raster`, `play voxel`: what an engine draws in a window, with keys and mouse for its input. */
object PlayCommand extends CommandLine {
  val name = "play"
  val summary = "shows what an engine draws in a window and takes keys and mouse: play pong, play raster, play voxel"

  private val parser: OParser[_, PlayOptions] = {
    val builder = OParser.builder[PlayOptions]
    import builder._
    OParser.sequence(
      programName("./sbt play"),
      head(s"play: $summary"),
      arg[String]("pong|raster|voxel").optional().action((v, o) => o.copy(what = v)).text("what to play"),
      opt[String]("engine").valueName("NAME").action((v, o) => o.copy(engine = Some(v)))
        .text(
          s"pong: ${PlayPong.Engines.mkString(", ")}; raster: ${PlayRaster.Engines.mkString(", ")};\n" +
            s"voxel: ${PlayVoxel.Engines.mkString(", ")} (default the first of them)"
        ),
      opt[VideoMode]("mode")(
        Arguments.oneOf(PongOptions.modes: _*)
      ).valueName(PongOptions.modes.map(_._1).mkString("|"))
        .action((v, o) => o.copy(mode = v)).text(s"pong's (default ${PongOptions.modes.head._1})"),
      opt[String]("scene")(Arguments.oneOf(Scenes.names.map(n => n -> n): _*)).valueName(Scenes.names.mkString("|"))
        .action((v, o) => o.copy(scene = Some(v))).text("raster's (default teapot)"),
      opt[Path]("obj")(Arguments.file).valueName("FILE").action((v, o) => o.copy(obj = Some(v)))
        .text("raster's: a mesh, as render takes it"),
      opt[Path]("world")(Arguments.file).valueName("FILE").action((v, o) =>
        o.copy(voxel = o.voxel.copy(world = Some(v)))
      )
        .text("voxel's: raw ids of 64x64x32 blocks, or MagicaVoxel .vox (default: hills from --seed)"),
      opt[(Int, Int, Int)]("crop")(VoxelOptions.crop).valueName("x,y,z")
        .action((v, o) => o.copy(voxel = o.voxel.copy(crop = Some(v))))
        .text("voxel's: takes the part of a .vox scene from this voxel on (default: the whole scene)"),
      opt[Unit]("opaque").action((_, o) => o.copy(voxel = o.voxel.copy(opaque = true)))
        .text("voxel's: glass of a .vox scene is solid (default: see-through)"),
      opt[(Int, Int)]("size")(Arguments.size).valueName("WxH").action((v, o) => o.copy(size = Some(v)))
        .text("raster's and voxel's, pixels (default 240x320 and 160x120)"),
      opt[Unit]("fly").action((_, o) => o.copy(fly = true)).text("voxel: without gravity"),
      opt[Int]("frames")(Arguments.count).valueName("N").action((v, o) => o.copy(frames = Some(v)))
        .text("ends after so many (default: when the window is closed)"),
      opt[Long]("seed")(Arguments.seed).valueName("N").action((v, o) => o.copy(seed = v))
        .text("of whatever is random at the start of the simulation, and of the hills (default 1)"),
      note(
        s"  --help                   prints this\n\npong: ${PongKeys.help}\nraster: ${RasterView.help}\n" +
          s"voxel: ${VoxelKeys.help}"
      )
    )
  }

  def run(args: Seq[String]): Int = Arguments.parse(name, parser, args, PlayOptions()).fold(0) { o =>
    o.what match {
      case "pong"   => PlayPong(o)
      case "raster" => PlayRaster(o)
      case "voxel"  => PlayVoxel(o)
      case other    =>
        throw InputError(s"argument: there is no '$other' to play; write play pong, play raster or play voxel")
    }
  }

  /** What is printed at the end. */
  private[play] def summaryOf(shown: Int, started: Long, more: String): String = {
    val rate = shown * 1e9 / (System.nanoTime - started)
    s"$shown frames, ${"%.1f".formatLocal(Locale.ROOT, rate)} a second, $more"
  }
}
