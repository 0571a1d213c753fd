package frustum.command.fit

import frustum.boards.flow.{Ice40Flow, Ice40Tools, MissingTool, Nextpnr}
import frustum.boards.icebreaker.IcebreakerTops
import frustum.command.common.{Arguments, CommandLine}
import frustum.command.render.RenderCommand
import frustum.contract.InputError
import frustum.contract.raster.{PlaneFormats, RasterConfig}
import frustum.contract.video.Panel
import frustum.device.Tech
import frustum.driver.raster.DrawOptions
import frustum.engine.raster.{EngineOptions, RasterEngines}
import frustum.files.{Notices, OutputFile}
import frustum.fit.{CameraVolume, Fit, FitBudget, FitFeatures, FitResult, Referee}
import frustum.picture.Picture
import frustum.raster.RasterPipeline
import frustum.reference.raster.Mesa
import frustum.scene.ObjScene
import frustum.synthesis.UnitCosts
import java.nio.file.{Path, Paths}

/** `fit`: the cheapest configuration that draws a scene from all of a volume of views within a budget of errors. */
object FitCommand extends CommandLine {
  val name = "fit"
  val summary = "finds the least hardware that draws a scene within an error budget; writes out/fit"

  /** Views that the generated hardware draws. */
  private val HardwareViews = 3

  def run(args: Seq[String]): Int = Arguments.parse(name, FitOptions.parser, args, FitOptions()).fold(0)(fit)

  private def fit(o: FitOptions): Int = {
    if (o.scene.isEmpty && o.obj.isEmpty) throw InputError("fit: no scene; give --scene NAME or --obj FILE")
    val base = RenderCommand.configOf(o.size._1, o.size._2)
    if (o.synthesis) Panel.Ili9341.fault(base.width, base.height).foreach(fault =>
      throw InputError(
        s"--size ${base.width}x${base.height}: $fault, which icebreaker-raster has; take a smaller size or " +
          "--no-synthesis"
      )
    )
    val volume = o.volume.fold(CameraVolume.default)(CameraVolume.read)
    val aspect = base.width.toDouble / base.height
    val own = RenderCommand.sceneOf(o.scene, o.obj, ObjScene.Options(o.texture, None, base.textureTexels, aspect))
    val scene = if (o.obj.isEmpty) own else own.copy(camera = volume.framed(own))
    val stem = o.obj.fold(scene.name)(_.getFileName.toString.replaceFirst("\\.[^.]*$", ""))
    val budget = FitBudget(o.texelsWrong, o.primitivesWrong, o.flip)
    val features = FitFeatures(scene, base, DrawOptions(o.light, o.cullBack, o.wrap, scene.background), volume)
    Notices.print(scene.notices)
    def say(line: String): Unit = println(s"$name $stem: $line")
    if (!features.options.depthTest)
      say("nothing hides anything else: no depth test" + (if (features.options.cullBack)
                                                            ", back faces are culled"
                                                          else ""))
    val search = new Fit(scene, features, budget, volume, o.seed, say)
    val result = search.run()
    say(
      f"${result.heldOutOver} of ${result.heldOut.length} views that took no part are over: at most " +
        f"${100 * result.overAtMost}%.1f %% of all views, with 95 %% confidence"
    )
    val frames = result.worst.take(HardwareViews).map { case (view, _) =>
      search.prepare(view, result.features.config.formats)
    }
    val different = {
      def images(engine: String) =
        RasterEngines.byName(engine).make(EngineOptions(o.seed, None)).drawAll(frames).map(_.image)
      images("pipeline").zip(images("model")).map { case (a, b) =>
        a.indices.count(i => a(i) != b(i)).toLong
      }.sum
    }
    say(s"hardware against model on the ${frames.length} worst views: $different pixels differ")

    val referee = Mesa.found.map(Referee(_, search, result))
    say(referee.fold(Mesa.Missing)(_.toString))

    val out = o.out.getOrElse(Paths.get("out", name, s"$stem.json"))
    val folder = Option(out.toAbsolutePath.getParent).get
    val costs = if (o.synthesis) Some(synthesise(base, result.features.config, folder, say)) else None
    val report = FitReport.json(o, result, different, referee, costs)
    OutputFile.writeText(out, ujson.write(report, indent = 2) + "\n")
    val views = (result.heldOut.map(v => "held out" -> v) ++ result.trained.map(v => "training" -> v)).map {
      case (part, (v, e)) =>
        Seq[Any](
          part,
          v.turn,
          v.elevation,
          v.distance,
          e.texelsWrong,
          e.primitivesWrong,
          e.flip.mkString,
          budget.share(e)
        ).mkString(",")
    }
    val stemOut = out.getFileName.toString.stripSuffix(".json")
    OutputFile.writeText(
      folder.resolve(s"$stemOut.csv"),
      ("part,turn,elevation,distance,texelsWrongPercent,primitivesWrongPercent,flip,shareOfBudget" +: views).mkString(
        "",
        "\n",
        "\n"
      )
    )
    val picture = folder.resolve(s"$stemOut-worst.png")
    val worst = RasterEngines.byName("model").make(EngineOptions(o.seed, None)).drawAll(frames.take(1)).head.image
    Picture.writePng(picture, base.width, base.height, Picture.ofRgb565(worst))
    OutputFile.writeText(folder.resolve("index.html"), FitReport.page(stem, result, report, picture))
    println(s"wrote $out")
    println(FitReport.scala(result.features))
    verdict(stem, result, different, referee)
  }

  private def verdict(stem: String, result: FitResult, different: Long, referee: Option[Referee]): Int = {
    val (view, errors) = result.worst.head
    if (different > 0) Console.err.println(s"error: $stem: $different pixels differ from the model's")
    if (!result.met) Console.err.println(
      s"error: $stem: not met: ${result.heldOutOver} of ${result.heldOut.length} views are over; the worst, $view, " +
        "has " +
        s"${errors.texelsWrong} % of its texels and ${errors.primitivesWrong} % of its pixels wrong" +
        errors.flip.fold("")(f => s", FLIP $f") +
        (if (result.features.config.formats == PlaneFormats()) ", with all the bits there are" else "")
    )
    val overruled = referee.filter(r => result.met && !r.met)
    for (r <- overruled) Console.err.println(s"error: $stem: overruled: $r")
    if (result.met && different == 0 && overruled.isEmpty) 0 else 1
  }

  private def synthesise(
      full: RasterConfig,
      fitted: RasterConfig,
      folder: Path,
      say: String => Unit
  ): FitCosts =
    try {
      val flow = new Ice40Flow(Ice40Tools.find(say))
      val work = OutputFile.folder(folder.resolve("build"))
      def place(what: String, c: RasterConfig) = {
        say(s"placing the $what")
        flow.run(IcebreakerTops.rasterOf(s"fit-$what", c), Seq(1), work, say, Nextpnr.Heap)
      }
      val costs = new UnitCosts(say)
      def cost(what: String, c: RasterConfig) = {
        val u = costs(s"the pipeline $what")(RasterPipeline(c, dropWhenFull = true, tech = Tech.Ice40))
        (u.luts, u.flipFlops)
      }
      val (luts, flipFlops) = cost("as fitted", fitted)
      val f = fitted.formats
      val restored = fitted.fixed.constant.map(field =>
        s"choice of $field" -> fitted.copy(fixed = fitted.fixed.without(field))
      ) ++
        Seq(
          Option.when(f.coordinate > 0)(s"${f.coordinate} bits of coordinates" -> f.copy(coordinate = 0)),
          Option.when(f.coordinate > 0)("1 bit of coordinates" -> f.copy(coordinate = f.coordinate - 1)),
          Option.when(f.inverse > 0)(s"${f.inverse} bits of 1/w" -> f.copy(inverse = 0)),
          Option.when(f.depth > 0)(s"${f.depth} bits of depth" -> f.copy(depth = 0)),
          Option.when(f.color > 0)(s"${f.color} bits of colours" -> f.copy(color = 0))
        ).flatten.map { case (what, formats) => what -> fitted.copy(formats = formats) } ++
        Seq(
          "choice of clear colour" -> fitted.copy(clearColor = None),
          "the whole store" -> fitted.copy(maxVertices = full.maxVertices, maxTriangles = full.maxTriangles),
          "positions everywhere" -> fitted.copy(ranges = fitted.ranges.copy(position = full.ranges.position)),
          "coordinates of all repeats" -> fitted.copy(ranges = fitted.ranges.copy(repeats = full.ranges.repeats)),
          "any ratio of depths" -> fitted.copy(ranges = fitted.ranges.copy(ratio = full.ranges.ratio))
        ).filter(_._2 != fitted)
      val savings = restored.map { case (what, c) =>
        val (l, d) = cost(s"with $what", c)
        (what, l - luts, d - flipFlops)
      }
      FitCosts(place("scene", fitted), place("full", full), savings)
    } catch { case MissingTool(message) => throw InputError(s"$message; or give --no-synthesis") }
}
