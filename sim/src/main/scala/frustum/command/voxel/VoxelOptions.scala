package frustum.command.voxel

import frustum.command.common.Arguments
import frustum.contract.voxel.{LeapField, VoxelConfig}
import frustum.driver.linear.Vector3
import frustum.engine.voxel.{VoxelEngineEntry, VoxelEngines}
import scopt.{OParser, Read}
import java.nio.file.{Path, Paths}

/** Arguments of `voxel`. */
final case class VoxelOptions(
    world: Option[Path] = None,
    worldSize: (Int, Int, Int) = (64, 64, 32),
    blocks: Option[Path] = None,
    crop: Option[(Int, Int, Int)] = None,
    opaque: Boolean = false,
    eye: Option[Vector3] = None,
    yaw: Option[Double] = None,
    pitch: Option[Double] = None,
    look: Option[Vector3] = None,
    size: (Int, Int) = (320, 240),
    focal: Option[Double] = None,
    distance: Int = 24,
    leaps: Option[LeapField] = None,
    highlight: Boolean = false,
    engine: VoxelEngineEntry = VoxelEngines.default,
    path: Option[Path] = None,
    serial: Option[Path] = None,
    out: Path = Paths.get("out", "voxel", "voxel.png"),
    report: Option[Path] = None,
    seed: Long = 1
) {

  /** As asked for, or the engine's. */
  def leapField: LeapField = leaps.getOrElse(engine.leaps)
  def reportFile: Path = report.getOrElse(out.resolveSibling("voxel.json"))
}

object VoxelOptions {
  val leaps: Seq[(String, LeapField)] = Seq(
    "quadrants" -> LeapField.Quadrants,
    "octants" -> LeapField.Octants,
    "up-down" -> LeapField.UpDown,
    "chebyshev" -> LeapField.Chebyshev,
    "none" -> LeapField.Plain
  )

  private val worldSize: Read[(Int, Int, Int)] = Read.reads { text =>
    text.split("x", -1).map(_.toIntOption) match {
      case Array(Some(x), Some(y), Some(z)) => (x, y, z)
      case _ => throw new IllegalArgumentException(s"'$text' is not a size such as 64x64x32")
    }
  }

  /** Voxels of a .vox scene. */
  val crop: Read[(Int, Int, Int)] = Read.reads { text =>
    text.split(",", -1).map(_.toIntOption.filter(_ >= 0)) match {
      case Array(Some(x), Some(y), Some(z)) => (x, y, z)
      case _                                => throw new IllegalArgumentException(s"'$text' is no place such as 0,64,0")
    }
  }

  private val distance: Read[Int] = Read.reads { text =>
    text.toIntOption.filter(n => n >= 1 && n <= VoxelConfig.MostDistance).getOrElse(
      throw new IllegalArgumentException(
        s"'$text' is not a whole number of blocks from 1 to ${VoxelConfig.MostDistance}"
      )
    )
  }

  val parser: OParser[_, VoxelOptions] = {
    val builder = OParser.builder[VoxelOptions]
    import builder._
    def option[A](
        name: String,
        value: String,
        text: String,
        read: Read[A]
    )(set: (VoxelOptions, A) => VoxelOptions) =
      opt[A](name)(read).valueName(value).action((v, o) => set(o, v)).text(text)
    OParser.sequence(
      programName("./sbt voxel"),
      head(s"voxel: ${VoxelCommand.summary}"),
      option[Path](
        "world",
        "FILE",
        "raw ids, or MagicaVoxel .vox (default: hills from --seed)",
        Arguments.file
      )((o, v) =>
        o.copy(world = Some(v))
      ),
      option[(Int, Int, Int)]("world-size", "XxYxZ", "blocks, powers of two (default 64x64x32)", worldSize)((o, v) =>
        o.copy(worldSize = v)
      ),
      option[Path](
        "blocks",
        "FILE.json",
        "kinds of block; docs/voxel.md tells the form (default: 24 of ours)",
        Arguments.file
      )((o, v) => o.copy(blocks = Some(v))),
      option[(Int, Int, Int)](
        "crop",
        "x,y,z",
        "takes the part of a .vox scene from this voxel on (default: the whole scene)",
        crop
      )((o, v) => o.copy(crop = Some(v))),
      opt[Unit]("opaque").action((_, o) => o.copy(opaque = true))
        .text("glass of a .vox scene is solid (default: see-through)"),
      option[Vector3](
        "eye",
        "x,y,z",
        "in blocks (default: a standing person's in the middle of the world)",
        Arguments.vector
      )((o, v) => o.copy(eye = Some(v))),
      option[Double]("yaw", "DEG", "0 looks along +x, 90 along +y (default 30)", Arguments.finite)((o, v) =>
        o.copy(yaw = Some(v))
      ),
      option[Double]("pitch", "DEG", "-90 to 90, up is positive (default -10)", Arguments.finite)((o, v) =>
        o.copy(pitch = Some(v))
      ),
      option[Vector3]("look", "dx,dy,dz", "direction, instead of --yaw and --pitch", Arguments.vector)((o, v) =>
        o.copy(look = Some(v))
      ),
      option[(Int, Int)]("size", "WxH", "pixels (default 320x240)", Arguments.size)((o, v) =>
        o.copy(size = v)
      ),
      option[Double](
        "focal",
        "PIXELS",
        "from the eye to the screen (default 225 * height / 240)",
        Arguments.positive
      )((o, v) =>
        o.copy(focal = Some(v))
      ),
      option[Int]("distance", "BLOCKS", "view distance (default 24)", distance)((o, v) =>
        o.copy(distance = v)
      ),
      option[LeapField](
        "leaps",
        leaps.map(_._1).mkString("|"),
        s"over air (default ${leaps.head._1}, with --engine compact up-down)",
        Arguments.oneOf(leaps: _*)
      )((o, v) => o.copy(leaps = Some(v))),
      opt[Unit]("highlight").action((_, o) => o.copy(highlight = true))
        .text(s"the face in the middle of the picture, if within ${VoxelConfig.Reach} blocks"),
      option[VoxelEngineEntry](
        "engine",
        VoxelEngines.names.mkString("|"),
        s"what draws; compact, formerly small, is icebreaker-voxel's pipeline (default ${VoxelEngines.default.name})",
        Arguments.engine(VoxelEngines)
      )((o, v) => o.copy(engine = v)),
      option[Path](
        "path",
        "FILE",
        "poses, a line each: x y z yaw pitch; %d in --out is the line's number",
        Arguments.file
      )((o, v) => o.copy(path = Some(v))),
      option[Path](
        "serial",
        "FILE",
        "the world and the last view as a host sends them to arty-voxel, with --engine compact to icebreaker-voxel " +
          "(default: none)",
        Arguments.file
      )((o, v) => o.copy(serial = Some(v))),
      option[Path](
        "out",
        "FILE.png",
        "(default out/voxel/voxel.png, with --path out/voxel/voxel-%d.png)",
        Arguments.file
      )((o, v) => o.copy(out = v)),
      option[Path]("report", "FILE.json", "(default voxel.json beside --out)", Arguments.file)((o, v) =>
        o.copy(report = Some(v))
      ),
      option[Long]("seed", "N", "of the hills (default 1)", Arguments.seed)((o, v) => o.copy(seed = v)),
      note("  --help                   prints this")
    )
  }
}
