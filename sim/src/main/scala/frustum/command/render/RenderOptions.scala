package frustum.command.render

import frustum.command.common.Arguments
import frustum.contract.raster.Wrap
import frustum.contract.video.Panel
import frustum.driver.linear.Vector3
import frustum.driver.scene.TextureImage
import frustum.engine.raster.{RasterEngineEntry, RasterEngines}
import frustum.scene.Scenes
import scopt.OParser
import java.nio.file.Path

/** Arguments of `render`; None where the default depends on the scene. Angles in degrees, lengths in world
  * units.
  */
final case class RenderOptions(
    scene: Option[String] = None,
    obj: Option[Path] = None,
    texture: Option[Path] = None,
    textureSize: Option[Int] = None,
    strict: Boolean = false,
    eye: Option[Vector3] = None,
    at: Option[Vector3] = None,
    up: Option[Vector3] = None,
    fov: Option[Double] = None,
    near: Option[Double] = None,
    far: Option[Double] = None,
    ortho: Option[Double] = None,
    size: (Int, Int) = (240, 320),
    light: Option[Vector3] = None,
    cullBack: Boolean = false,
    filter: String = "nearest",
    wrap: Wrap = Wrap.Repeat,
    background: Int = 0,
    engine: RasterEngineEntry = RasterEngines.default,
    panel: Option[Panel] = None,
    frames: Int = 1,
    turn: Option[Double] = None,
    wave: Option[Path] = None,
    out: Option[Path] = None,
    report: Option[Path] = None,
    seed: Long = 1
)

object RenderOptions {
  private val builder = OParser.builder[RenderOptions]
  import builder._
  import Arguments._

  private def option[A](name: String, value: String, text: String)(set: (A, RenderOptions) => RenderOptions)(
      implicit read: scopt.Read[A]
  ) = opt[A](name).valueName(value).action(set).text(text)

  private val sceneOptions = OParser.sequence(
    option[String]("scene", Scenes.names.mkString("|"), "a scene made in code (default teapot)")((v, o) =>
      o.copy(scene = Some(v))
    )(
      oneOf(Scenes.names.map(n => n -> n): _*)
    ),
    option[Path](
      "obj",
      "FILE",
      "a mesh: OBJ, with MTL and pictures (PNG, JPEG, TGA) beside it"
    )((v, o) => o.copy(obj = Some(v)))(file),
    option[Path]("texture", "FILE.png", "overrides the textures (default: the scene's own)")((v, o) =>
      o.copy(texture = Some(v))
    )(file),
    option[Int](
      "texture-size",
      TextureImage.Sides.mkString("|"),
      "side of pictures whose own the hardware does not take\n(default: the largest with which all fit)"
    )((v, o) => o.copy(textureSize = Some(v)))(oneOf(TextureImage.Sides.map(n => n.toString -> n): _*)),
    opt[Unit]("strict").action((_, o) => o.copy(strict = true))
      .text("notices about files are errors (default: what is missing or unknown is left out)")
  )

  private val cameraOptions = {
    val own = "(default: the scene's; an OBJ is framed)"
    OParser.sequence(
      option[Vector3]("eye", "x,y,z", s"where the camera is $own")((v, o) => o.copy(eye = Some(v)))(vector),
      option[Vector3]("at", "x,y,z", s"where it looks $own")((v, o) => o.copy(at = Some(v)))(vector),
      option[Vector3]("up", "x,y,z", s"what is upwards $own")((v, o) => o.copy(up = Some(v)))(vector),
      option[Double]("fov", "DEG", "vertical field of view (default: the scene's; 45 for an OBJ)")((v, o) =>
        o.copy(fov = Some(v))
      )(positive),
      option[Double](
        "near",
        "DISTANCE",
        s"near clipping plane $own"
      )((v, o) => o.copy(near = Some(v)))(finite),
      option[Double]("far", "DISTANCE", s"far clipping plane $own")((v, o) => o.copy(far = Some(v)))(finite),
      option[Double]("ortho", "H", "orthographic view H world units high (default: perspective)")((v, o) =>
        o.copy(ortho = Some(v))
      )(positive)
    )
  }

  private val lookOptions = OParser.sequence(
    option[(Int, Int)]("size", "WxH", "pixels (default 240x320)")((v, o) => o.copy(size = v))(Arguments.size),
    option[Option[Vector3]](
      "light",
      "none|x,y,z",
      "direction towards the light: Lambert per vertex, ambient 0.2\n" +
        "(default none: texture or vertex colour alone)"
    )((v, o) => o.copy(light = v))(scopt.Read.reads(t => Option.when(t != "none")(vector.reads(t)))),
    option[Boolean]("cull", "none|back", "faces left out (default none)")((v, o) => o.copy(cullBack = v))(
      oneOf("none" -> false, "back" -> true)
    ),
    option[String]("filter", "nearest|bilinear", "texture filter (default nearest)")((v, o) =>
      o.copy(filter = v)
    )(
      oneOf("nearest" -> "nearest", "bilinear" -> "bilinear")
    ).validate(v =>
      if (v == "nearest") success else failure("--filter bilinear: only nearest is built; leave it out")
    ),
    option[Wrap]("wrap", "repeat|mirror|clamp", "coordinates outside the texture (default repeat)")((v, o) =>
      o.copy(wrap = v)
    )(oneOf("repeat" -> Wrap.Repeat, "mirror" -> Wrap.Mirror, "clamp" -> Wrap.Clamp)),
    option[Int]("background", "RRGGBB", "(default 000000)")((v, o) => o.copy(background = v))(color)
  )

  private val runOptions = OParser.sequence(
    option[RasterEngineEntry](
      "engine",
      RasterEngines.names.mkString("|"),
      "what draws: the top at its pins, the stream core, the bit-exact model, float64\n" +
        s"(default ${RasterEngines.default.name})"
    )((v, o) => o.copy(engine = v))(Arguments.engine(RasterEngines)),
    option[Panel](
      "panel",
      Panel.all.map(_.name).mkString("|"),
      s"display at the pins; engine hardware (default ${Panel.Ili9341.name})"
    )((v, o) =>
      o.copy(panel = Some(v))
    )(oneOf(Panel.all.map(p => p.name -> p): _*)),
    option[Int]("frames", "N", "frames of an animation; with more than one put %d in --out (default 1)")((v, o) =>
      o.copy(frames = v)
    )(count),
    option[Double]("turn", "DEG", "turn about +y from each frame to the next (default 360 / frames)")((v, o) =>
      o.copy(turn = Some(v))
    )(finite),
    option[Path]("wave", "FILE.fst", "waveform; engines hardware and pipeline (default: none)")((v, o) =>
      o.copy(wave = Some(v))
    )(file),
    option[Path](
      "out",
      "FILE.png",
      "(default out/render/SCENE.png, for an animation out/render/SCENE-%d.png)"
    )((v, o) =>
      o.copy(out = Some(v))
    )(file),
    option[Path]("report", "FILE.json", "(default out/render/SCENE.json)")((v, o) =>
      o.copy(report = Some(v))
    )(file),
    option[Long]("seed", "N", "of whatever is random (default 1)")((v, o) => o.copy(seed = v))(Arguments.seed)
  )

  val parser: OParser[_, RenderOptions] = OParser.sequence(
    programName("./sbt render"),
    head("render: draws a scene or a mesh and reports how well"),
    sceneOptions,
    cameraOptions,
    lookOptions,
    runOptions,
    note("  --help                   prints this")
  )
}
