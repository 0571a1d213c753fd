package frustum.command.common

import java.util.Locale

/** The key figures of reports as text: what the table on the terminal and the page show. */
object ReportTable {

  /** Heading, and the figure as it is shown; "-" where the report has none. */
  val columns: Seq[(String, ujson.Obj => String)] = Seq(
    "triangles" -> (r => whole(r, "trianglesDrawn")),
    "fragments" -> (r => whole(r, "fragments")),
    "clocks" -> (r => whole(r, "clocksPerFrame")),
    "clocks at pins" -> (r => whole(r, "clocksPerFrameAtPins")),
    "frames/s at pins" -> (r => decimal(r, "framesPerSecondAtPins")),
    "hardware != model" -> (r => whole(r, "hardwareVsModel", "pixelsDifferent")),
    "coverage wrong" -> (r => whole(r, "modelVsReference", "coverageWrong")),
    "texels wrong" -> texels,
    "order wrong" -> (r => whole(r, "modelVsReference", "depthOrderWrong")),
    "objects wrong" -> rays,
    "PSNR dB" -> (r =>
      if (r.obj.contains("psnr")) decimal(r, "psnr") else decimal(r, "modelVsReference", "psnr")
    ),
    "end to end wrong" -> endToEnd,
    "end to end PSNR dB" -> (r => decimal(r, "endToEnd", "psnr")),
    "FLIP" -> (r => value(r, "endToEnd", "flip").fold("-")(v => format("%.4f", v.num)))
  )

  def apply(reports: Seq[ujson.Obj]): String = {
    val rows = ("scene" +: columns.map(_._1)) +: reports.map(r => r("scene").str +: columns.map(_._2(r)))
    val widths = rows.transpose.map(_.map(_.length).max)
    rows.map(row =>
      row.zip(widths).zipWithIndex.map { case ((cell, width), column) =>
        if (column == 0) cell.padTo(width, ' ') else cell.reverse.padTo(width, ' ').reverse
      }.mkString("  ")
    ).mkString("\n")
  }

  private def value(report: ujson.Obj, path: String*): Option[ujson.Value] =
    path.foldLeft(Option[ujson.Value](report))((at, key) => at.flatMap(_.obj.get(key)))

  private def format(pattern: String, v: Double) = pattern.formatLocal(Locale.ROOT, v)

  private def whole(r: ujson.Obj, path: String*) = value(r, path: _*).fold("-")(v => format("%,.0f", v.num))

  private def decimal(r: ujson.Obj, path: String*) =
    value(r, path: _*).fold("-")(v => if (v.isNull) "equal" else format("%.1f", v.num))

  /** Everything of a ray caster that is to be exact. */
  private def rays(r: ujson.Obj) = {
    val keys = Seq(
      "silhouettePixelsWrong",
      "shadowPixelsWrong",
      "objectPixelsWrong",
      "checkerCellsWrong", // pong
      "blocksWrong",
      "facesWrong",
      "texelsWrong" // voxel
    ).flatMap(value(r, _))
    if (keys.isEmpty) "-" else format("%,.0f", keys.map(_.num).sum)
  }

  /** Primitives and texels that the referee finds wrong. */
  private def endToEnd(r: ujson.Obj) =
    if (r.obj.contains("endToEnd"))
      s"${whole(r, "endToEnd", "primitiveWrong")} + ${whole(r, "endToEnd", "texelsWrong")}"
    else "-"

  private def texels(r: ujson.Obj) = (for {
    wrong <- value(r, "modelVsReference", "texelsWrong")
    judged <- value(r, "modelVsReference", "texelsJudged")
  } yield if (judged.num == 0) "-" else format("%.3f %%", 100 * wrong.num / judged.num)).getOrElse("-")
}
