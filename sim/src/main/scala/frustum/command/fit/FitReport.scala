package frustum.command.fit

import frustum.boards.flow.BitstreamReport
import frustum.BuildInfo
import frustum.command.common.Page
import frustum.fit.{FitFeatures, FitResult, Referee, ViewErrors}
import java.nio.file.Path

/** @param savings LUT and flip-flops that come back when one thing saved does */
final case class FitCosts(
    fitted: BitstreamReport,
    full: BitstreamReport,
    savings: Seq[(String, Int, Int)]
)

/** What `fit` tells of its answer. */
object FitReport {

  /** The answer as code. */
  def scala(f: FitFeatures): String = {
    val (c, r) = (f.config, f.config.ranges)
    s"""RasterConfig(
       |  width = ${c.width}, height = ${c.height},
       |  maxVertices = ${c.maxVertices}, maxTriangles = ${c.maxTriangles}, textureTexels = ${c.textureTexels},
       |  fixed = ${c.fixed.code}, // ${c.fixed.constant.mkString(", ")}
       |  formats = PlaneFormats(coordinate = ${c.formats.coordinate}, depth = ${c.formats.depth},
       |    color = ${c.formats.color}, inverse = ${c.formats.inverse}),
       |  ranges = VertexRanges(position = ${r.position}, repeats = ${r.repeats}, ratio = ${r.ratio}),
       |  clearColor = ${c.clearColor.fold("None")(v => f"Some(0x$v%04x)")}
       |) // with DrawOptions(cullBack = ${f.options.cullBack}, depthTest = ${f.options.depthTest})""".stripMargin
  }

  private def cells(r: BitstreamReport): Int = r.placements.flatMap(_.used.get("ICESTORM_LC")).max

  def json(
      o: FitOptions,
      r: FitResult,
      different: Long,
      referee: Option[Referee],
      costs: Option[FitCosts]
  ): ujson.Obj = {
    val c = r.features.config
    def errors(e: ViewErrors) = {
      val all =
        ujson.Obj("texelsWrongPercent" -> e.texelsWrong, "primitivesWrongPercent" -> e.primitivesWrong)
      e.flip.foreach(all("flip") = _)
      all
    }
    val budget = ujson.Obj("texelsWrongPercent" -> o.texelsWrong)
    o.primitivesWrong.foreach(budget("primitivesWrongPercent") = _)
    o.flip.foreach(budget("flip") = _)
    val report = ujson.Obj(
      "command" -> FitCommand.name,
      "version" -> BuildInfo.version,
      "seed" -> o.seed.toDouble,
      "engine" -> "model",
      "met" -> r.met,
      "budget" -> budget,
      "achieved" -> errors(r.heldOut.maxBy { case (_, e) => r.budget.share(e) }._2),
      "worstView" -> r.worst.head._1.toString,
      "trainingViews" -> r.trained.length,
      "heldOutViews" -> r.heldOut.length,
      "heldOutOverBudget" -> r.heldOutOver,
      "overAtMostPercent" -> 100 * r.overAtMost,
      "oneBitLess" -> ujson.Obj.from(r.oneBitLess.map { case (knob, share) => knob -> ujson.Num(share) }),
      "hardwareVsModel" -> ujson.Obj("pixelsDifferent" -> different.toDouble),
      "configuration" -> ujson.Obj(
        "width" -> c.width,
        "height" -> c.height,
        "textureTexels" -> c.textureTexels,
        "maxVertices" -> c.maxVertices,
        "maxTriangles" -> c.maxTriangles,
        "positionBits" -> c.ranges.position,
        "repeatBits" -> c.ranges.repeats,
        "ratioBits" -> c.ranges.ratio,
        "clearColor" -> c.clearColor.fold[ujson.Value](ujson.Null)(ujson.Num(_)),
        "constant" -> c.fixed.constant,
        "fixed" -> ujson.Obj.from(c.fixed.constants.toSeq.sortBy(_._1).map { case (field, bits) =>
          field -> ujson.Obj("mask" -> bits.mask, "value" -> bits.value)
        }),
        "coordinate" -> c.formats.coordinate,
        "depth" -> c.formats.depth,
        "color" -> c.formats.color,
        "inverse" -> c.formats.inverse,
        "cullBack" -> r.features.options.cullBack,
        "depthTest" -> r.features.options.depthTest
      ),
      "scala" -> scala(r.features)
    )
    def judged(m: Referee) = ujson.Obj(
      "renderer" -> "llvmpipe",
      "views" -> m.views,
      "viewsOver" -> m.over,
      "texelsWrongPercent" -> m.texelsWrong,
      "primitivesWrongPercent" -> m.primitivesWrong
    )
    for (m <- referee) {
      report("referee") = judged(m)
      m.fromWorld.foreach(w => report("endToEnd") = judged(w))
    }
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

  def page(stem: String, r: FitResult, report: ujson.Obj, picture: Path): String = {
    def table(head: Seq[String], rows: Seq[Seq[Any]]) =
      (head.map(h => s"<th>$h</th>") +: rows.map(_.map(c => s"<td>$c</td>"))).map(_.mkString(
        "<tr>",
        "",
        "</tr>"
      )).mkString("<table>", "\n", "</table>")
    val figures = Seq(
      "met",
      "heldOutOverBudget",
      "heldOutViews",
      "overAtMostPercent",
      "logicCells",
      "fullPresetLogicCells",
      "clockMHz",
      "fullPresetClockMHz"
    )
      .flatMap(k => report.value.get(k).map(v => Seq(k, v.toString)))
    val savings = report.value.get("savings").toSeq.flatMap(_.arr).map(s =>
      Seq[Any](s("what").str, s("luts").num.toInt, s("flipFlops").num.toInt)
    )
    Page(
      s"Frustum: no more than $stem needs",
      s"""${table(Seq("figure", ""), figures)}
         |<pre>${scala(r.features)}</pre>
         |<figure><img alt="worst view" src="${Page.source(
          picture
        )}"><figcaption>The worst view found: ${r.worst.head._1}.</figcaption></figure>
         |<h2>What comes back with each thing saved</h2>
         |${table(Seq("", "LUT", "flip-flops"), savings)}""".stripMargin
    )
  }
}
