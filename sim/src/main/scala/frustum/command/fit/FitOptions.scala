package frustum.command.fit

import frustum.command.common.Arguments
import frustum.contract.raster.Wrap
import frustum.driver.linear.Vector3
import frustum.scene.Scenes
import scopt.OParser
import java.nio.file.Path

/** Arguments of `fit`. */
final case class FitOptions(
    scene: Option[String] = None,
    obj: Option[Path] = None,
    texture: Option[Path] = None,
    texelsWrong: Double = 0,
    primitivesWrong: Option[Double] = None,
    flip: Option[Double] = None,
    volume: Option[Path] = None,
    top: String = "icebreaker-raster",
    size: (Int, Int) = (240, 320),
    light: Option[Vector3] = None,
    cullBack: Boolean = false,
    wrap: Wrap = Wrap.Repeat,
    synthesis: Boolean = true,
    out: Option[Path] = None,
    seed: Long = 1
)

object FitOptions {
  private val builder = OParser.builder[FitOptions]
  import builder._
  import Arguments._

  private def option[A](name: String, value: String, text: String)(set: (A, FitOptions) => FitOptions)(
      implicit read: scopt.Read[A]
  ) = opt[A](name).valueName(value).action(set).text(text)

  val parser: OParser[_, FitOptions] = OParser.sequence(
    programName("./sbt fit"),
    head(s"fit: ${FitCommand.summary}"),
    option[String]("scene", Scenes.names.mkString("|"), "a scene made in code (this or --obj)")((v, o) =>
      o.copy(scene = Some(v))
    )(
      oneOf(Scenes.names.map(n => n -> n): _*)
    ),
    option[Path](
      "obj",
      "FILE",
      "a mesh: OBJ, with MTL and PNG beside it"
    )((v, o) => o.copy(obj = Some(v)))(file),
    option[Path]("texture", "FILE.png", "overrides the textures (default: the scene's own)")((v, o) =>
      o.copy(texture = Some(v))
    )(file),
    option[Double]("texels-wrong", "PERCENT", "of each view's texels, at most")((v, o) =>
      o.copy(texelsWrong = v)
    )(positive).required(),
    option[Double](
      "primitives-wrong",
      "PERCENT",
      "of the screen's pixels, at most (default: depth keeps all its bits)"
    )((v, o) =>
      o.copy(primitivesWrong = Some(v))
    )(positive),
    option[Double]("flip", "X", "mean FLIP, at most (default: colours keep all their bits)")((v, o) =>
      o.copy(flip = Some(v))
    )(positive),
    option[Path](
      "volume",
      "FILE.json",
      "views: {\"turn\": [low, high], \"elevation\": [low, high], \"distance\": [low, high]},\n" +
        "degrees, degrees and a factor, from the scene's own camera (default [-30, 30], [-10, 10], [0.9, 1.5])"
    )((v, o) =>
      o.copy(volume = Some(v))
    )(file),
    option[String](
      "top",
      "TOP",
      "what is built (default icebreaker-raster)"
    )((v, o) => o.copy(top = v))(oneOf("icebreaker-raster" -> "icebreaker-raster")),
    option[(Int, Int)](
      "size",
      "WxH",
      "of the screen, pixels (default 240x320)"
    )((v, o) => o.copy(size = v))(size),
    option[Option[Vector3]]("light", "none|x,y,z", "direction towards the light (default none)")((v, o) =>
      o.copy(light = v)
    )(scopt.Read.reads(t => Option.when(t != "none")(vector.reads(t)))),
    option[Boolean](
      "cull",
      "none|back",
      "faces left out (default none; of closed convex meshes always the back ones)"
    )((v, o) => o.copy(cullBack = v))(oneOf("none" -> false, "back" -> true)),
    option[Wrap]("wrap", "repeat|mirror|clamp", "of textures (default repeat)")((v, o) => o.copy(wrap = v))(
      oneOf("repeat" -> Wrap.Repeat, "mirror" -> Wrap.Mirror, "clamp" -> Wrap.Clamp)
    ),
    opt[Unit]("no-synthesis").action((_, o) => o.copy(synthesis = false)).text(
      "neither cells nor clock: the search and the simulation alone"
    ),
    option[Path]("out", "FILE.json", "the report (default out/fit/SCENE.json)")((v, o) =>
      o.copy(out = Some(v))
    )(file),
    option[Long]("seed", "N", "of the views (default 1)")((v, o) => o.copy(seed = v))(Arguments.seed),
    note("  --help                   prints this")
  )
}
