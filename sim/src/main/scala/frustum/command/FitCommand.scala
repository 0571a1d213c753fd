package frustum.command

import frustum.blackbox.Tech
import frustum.boards.flow.{BitstreamReport, Ice40Flow, Ice40Tools, MissingTool}
import frustum.boards.icebreaker.IcebreakerTops
import frustum.engine.{EngineOptions, Engines}
import frustum.host.DrawOptions
import frustum.lab._
import frustum.picture.Picture
import frustum.pipelines.RasterPipeline
import frustum.spec.{PlaneFormats, RasterConfig}
import frustum.{BuildInfo, InputError, OutputFile}
import java.nio.file.{Files, Path, Paths}

/** `fit`: the cheapest configuration that draws a scene from all of a volume of views within a budget of errors. */
object FitCommand extends CommandLine {
  val name    = "fit"
  val summary = "finds the least hardware that draws a scene within an error budget; writes out/fit"

  /** Views that the generated hardware draws. */
  private val HardwareViews = 3

  def run(args: Seq[String]): Int = Arguments.parse(name, FitOptions.parser, args, FitOptions()).fold(0)(fit)

  private def fit(o: FitOptions): Int = {
    if (o.scene.isEmpty && o.obj.isEmpty) throw InputError("fit: no scene; give --scene NAME or --obj FILE")
    val scene    = RenderCommand.sceneOf(o.scene, o.obj, o.texture)
    val stem     = o.obj.fold(scene.name)(_.getFileName.toString.replaceFirst("\\.[^.]*$", ""))
    val base     = RenderCommand.configOf(o.size._1, o.size._2)
    val volume   = o.volume.fold(CameraVolume.default)(CameraVolume.read)
    val budget   = FitBudget(o.texelsWrong, o.primitivesWrong, o.flip)
    val features = FitFeatures(scene, base, DrawOptions(o.light, o.cullBack, o.wrap, scene.background))
    def say(line: String): Unit = println(s"$name $stem: $line")
    if (!features.options.depthTest) say("nothing hides anything else: no depth test" + (if (features.options.cullBack) ", back faces are culled" else ""))
    val search = new Fit(scene, features, budget, volume, o.seed, say)
    val result = search.run()
    say(
      f"${result.heldOutOver} of ${result.heldOut.length} views that took no part are over: at most ${100 * result.overAtMost}%.1f %% of all views, with 95 %% confidence"
    )
    val frames    = result.worst.take(HardwareViews).map { case (view, _) => search.prepare(view, result.features.config.formats) }
    val different = {
      def images(engine: String) = Engines.byName(engine).make(EngineOptions(o.seed, None)).render(frames).map(_.image)
      images("pipeline").zip(images("model")).map { case (a, b) => a.indices.count(i => a(i) != b(i)).toLong }.sum
    }
    say(s"hardware against model on the ${frames.length} worst views: $different pixels differ")

    val out    = o.out.getOrElse(Paths.get("out", name, s"$stem.json"))
    val folder = Option(out.toAbsolutePath.getParent).get
    val costs  = if (o.synthesis) Some(synthesise(base, result.features.config, folder, say)) else None
    val report = json(o, result, different, costs)
    OutputFile.writeText(out, ujson.write(report, indent = 2) + "\n")
    val views = (result.heldOut.map(v => "held out" -> v) ++ result.trained.map(v => "training" -> v)).map { case (part, (v, e)) =>
      Seq(part, v.turn, v.elevation, v.distance, e.texelsWrong, e.primitivesWrong, e.flip.mkString, budget.share(e)).mkString(",")
    }
    val stemOut = out.getFileName.toString.stripSuffix(".json")
    OutputFile.writeText(
      folder.resolve(s"$stemOut.csv"),
      ("part,turn,elevation,distance,texelsWrongPercent,primitivesWrongPercent,flip,shareOfBudget" +: views).mkString("", "\n", "\n")
    )
    val picture = folder.resolve(s"$stemOut-worst.png")
    val worst   = Engines.byName("model").make(EngineOptions(o.seed, None)).render(frames.take(1)).head.image
    Picture.writePng(picture, base.width, base.height, Picture.ofRgb565(worst))
    OutputFile.writeText(folder.resolve("index.html"), page(stem, result, report, picture))
    println(s"wrote $out")
    println(scala(result.features))
    verdict(stem, result, different)
  }

  private def verdict(stem: String, result: FitResult, different: Long): Int = {
    val (view, errors) = result.worst.head
    if (different > 0) Console.err.println(s"error: $stem: $different pixels differ from the model's")
    if (!result.met) Console.err.println(
      s"error: $stem: not met: ${result.heldOutOver} of ${result.heldOut.length} views are over; the worst, $view, has " +
        s"${errors.texelsWrong} % of its texels wrong" +
        (if (result.features.config.formats == PlaneFormats()) ", with all the bits there are" else "")
    )
    if (result.met && different == 0) 0 else 1
  }

  /** The answer as code. */
  private def scala(f: FitFeatures): String = {
    val c = f.config
    s"""RasterConfig(
       |  width = ${c.width}, height = ${c.height}, textureTexels = ${c.textureTexels},
       |  fixed = FixedState(mask = 0x${c.fixed.mask.toHexString}, value = 0x${c.fixed.value.toHexString}), // ${c.fixed.constant.mkString(", ")}
       |  formats = PlaneFormats(coordinate = ${c.formats.coordinate}, depth = ${c.formats.depth}, color = ${c.formats.color})
       |) // with DrawOptions(cullBack = ${f.options.cullBack}, depthTest = ${f.options.depthTest})""".stripMargin
  }

  /** @param savings LUT and flip-flops that come back when one thing saved does */
  private final case class Costs(fitted: BitstreamReport, full: BitstreamReport, savings: Seq[(String, Int, Int)])

  private def synthesise(full: RasterConfig, fitted: RasterConfig, folder: Path, say: String => Unit): Costs =
    try {
      val flow = new Ice40Flow(Ice40Tools.find(say))
      val work = Files.createDirectories(folder.resolve("build"))
      def place(what: String, c: RasterConfig) = {
        say(s"placing the $what")
        flow.run(IcebreakerTops.rasterOf(s"fit-$what", c), Seq(1), work, say)
      }
      val costs = new UnitCosts(say)
      def cost(what: String, c: RasterConfig) = {
        val u = costs(s"the pipeline $what")(RasterPipeline(c, tech = Tech.Ice40))
        (u.luts, u.flipFlops)
      }
      val (luts, flipFlops) = cost("as fitted", fitted)
      val f                 = fitted.formats
      val restored          = fitted.fixed.constant.map(field => s"choice of $field" -> fitted.copy(fixed = fitted.fixed.without(field))) ++
        Seq(
          Option.when(f.coordinate > 0)(s"${f.coordinate} bits of coordinates" -> f.copy(coordinate = 0)),
          Option.when(f.coordinate > 0)("1 bit of coordinates" -> f.copy(coordinate = f.coordinate - 1)),
          Option.when(f.depth > 0)(s"${f.depth} bits of depth" -> f.copy(depth = 0)),
          Option.when(f.color > 0)(s"${f.color} bits of colours" -> f.copy(color = 0))
        ).flatten.map { case (what, formats) => what -> fitted.copy(formats = formats) }
      val savings = restored.map { case (what, c) =>
        val (l, d) = cost(s"with $what", c)
        (what, l - luts, d - flipFlops)
      }
      Costs(place("scene", fitted), place("full", full), savings)
    } catch { case MissingTool(message) => throw InputError(s"$message; or give --no-synthesis") }

  private def cells(r: BitstreamReport): Int = r.placements.flatMap(_.used.get("ICESTORM_LC")).max

  private def json(o: FitOptions, r: FitResult, different: Long, costs: Option[Costs]): ujson.Obj = {
    val c                       = r.features.config
    def errors(e: ViewErrors)   = {
      val all = ujson.Obj("texelsWrongPercent" -> e.texelsWrong, "primitivesWrongPercent" -> e.primitivesWrong)
      e.flip.foreach(all("flip") = _)
      all
    }
    val budget = ujson.Obj("texelsWrongPercent" -> o.texelsWrong)
    o.primitivesWrong.foreach(budget("primitivesWrongPercent") = _)
    o.flip.foreach(budget("flip") = _)
    val report = ujson.Obj(
      "command"           -> name,
      "version"           -> BuildInfo.version,
      "seed"              -> o.seed.toDouble,
      "engine"            -> "model",
      "met"               -> r.met,
      "budget"            -> budget,
      "achieved"          -> errors(r.heldOut.maxBy { case (_, e) => r.budget.share(e) }._2),
      "worstView"         -> r.worst.head._1.toString,
      "trainingViews"     -> r.trained.length,
      "heldOutViews"      -> r.heldOut.length,
      "heldOutOverBudget" -> r.heldOutOver,
      "overAtMostPercent" -> 100 * r.overAtMost,
      "oneBitLess"        -> ujson.Obj.from(r.oneBitLess.map { case (knob, share) => knob -> ujson.Num(share) }),
      "hardwareVsModel"   -> ujson.Obj("pixelsDifferent" -> different.toDouble),
      "configuration"     -> ujson.Obj(
        "width"         -> c.width,
        "height"        -> c.height,
        "textureTexels" -> c.textureTexels,
        "constant"      -> c.fixed.constant,
        "fixedMask"     -> (c.fixed.mask & 0xffffffffL).toDouble,
        "fixedValue"    -> (c.fixed.value & 0xffffffffL).toDouble,
        "coordinate"    -> c.formats.coordinate,
        "depth"         -> c.formats.depth,
        "color"         -> c.formats.color,
        "cullBack"      -> r.features.options.cullBack,
        "depthTest"     -> r.features.options.depthTest
      ),
      "scala" -> scala(r.features)
    )
    costs.foreach { k =>
      report("logicCells") = cells(k.fitted)
      report("fullPresetLogicCells") = cells(k.full)
      if (k.fitted.fits) report("clockMHz") = k.fitted.coreMHz.min
      if (k.full.fits) report("fullPresetClockMHz") = k.full.coreMHz.min
      report("savings") = k.savings.map { case (what, luts, flipFlops) =>
        ujson.Obj("what" -> what, "luts" -> luts, "flipFlops" -> flipFlops)
      }
    }
    report
  }

  private def page(stem: String, r: FitResult, report: ujson.Obj, picture: Path): String = {
    def table(head: Seq[String], rows: Seq[Seq[Any]]) =
      (head.map(h => s"<th>$h</th>") +: rows.map(_.map(c => s"<td>$c</td>"))).map(_.mkString("<tr>", "", "</tr>")).mkString("<table>", "\n", "</table>")
    val figures = Seq("met", "heldOutOverBudget", "heldOutViews", "overAtMostPercent", "logicCells", "fullPresetLogicCells", "clockMHz", "fullPresetClockMHz")
      .flatMap(k => report.value.get(k).map(v => Seq(k, v.toString)))
    val savings = report.value.get("savings").toSeq.flatMap(_.arr).map(s => Seq(s("what").str, s("luts").num.toInt, s("flipFlops").num.toInt))
    Page(
      s"Frustum: no more than $stem needs",
      s"""${table(Seq("figure", ""), figures)}
         |<pre>${scala(r.features)}</pre>
         |<figure><img alt="worst view" src="${Page.source(picture)}"><figcaption>The worst view found: ${r.worst.head._1}.</figcaption></figure>
         |<h2>What comes back with each thing saved</h2>
         |${table(Seq("", "LUT", "flip-flops"), savings)}""".stripMargin
    )
  }
}
