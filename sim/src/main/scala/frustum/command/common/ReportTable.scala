package frustum.command.common

import java.util.Locale

/** The key figures of reports as text: what the table on the terminal and the page show. */
object ReportTable {

  /** A figure of the reports.
    *
    * @param meaning for readers who know neither the project nor the field
    * @param show    the figure as it is shown; "-" where the report has none
    */
  final case class Column(heading: String, meaning: String)(val show: ujson.Obj => String)

  val columns: Seq[Column] = Seq(
    Column("triangles", "triangles that were drawn, after clipping and culling")(r => whole(r, "trianglesDrawn")),
    Column("fragments", "pixels that the triangles cover, summed over the triangles")(r => whole(r, "fragments")),
    Column("cycles", "cycles of the engine's clock for a frame, with nothing to wait for")(r =>
      whole(r, "clocksPerFrame")
    ),
    Column("cycles at pins", "cycles from the first bit of a frame's commands to the display's last bit")(r =>
      whole(r, "clocksPerFrameAtPins")
    ),
    Column("frames/s at pins", "the board's clock frequency over the cycles at its pins")(r =>
      decimal(r, "framesPerSecondAtPins")
    ),
    Column("hardware != model", "pixels in which the simulated hardware and its bit-exact model differ; has to be 0")(
      r =>
        whole(r, "hardwareVsModel", "pixelsDifferent")
    ),
    Column(
      "coverage wrong",
      "pixels that are missing, too many or drawn twice, against exact arithmetic on the same vertices; has to be 0"
    )(r => whole(r, "modelVsReference", "coverageWrong")),
    Column(
      "texels wrong",
      "fragments that read another texel of the texture than exact arithmetic does, of those judged; " +
        "within 1/1024 texel of a border none is judged"
    )(texels),
    Column(
      "order wrong",
      "pixels that show a triangle that by exact depths lies behind the one that should show: depths have 16 bits"
    )(r => whole(r, "modelVsReference", "depthOrderWrong")),
    Column(
      "objects wrong",
      "rays that show another object, silhouette, shadow, cell, block, face or texel than exact arithmetic; has to be 0"
    )(rays),
    Column("PSNR dB", "signal-to-noise ratio of the picture against the reference beside it; higher is better")(r =>
      if (r.obj.contains("psnr")) decimal(r, "psnr") else decimal(r, "modelVsReference", "psnr")
    ),
    Column(
      "end to end wrong",
      "pixels that show another triangle, and pixels that show another texel, than the referee finds, which draws " +
        "the scene from the user's input and shares no code with what is judged; not judged within 1/8 pixel of an " +
        "edge and 1/64 texel of a border"
    )(endToEnd),
    Column("end to end PSNR dB", "signal-to-noise ratio of the picture against the referee's; higher is better")(r =>
      decimal(r, "endToEnd", "psnr")
    ),
    Column(
      "FLIP",
      "how different the picture and the referee's look to a person who flips between them, from 0 (equal) to 1; the " +
        "measure of Andersson and others, HPG 2020"
    )(r => value(r, "endToEnd", "flip").fold("-")(v => format("%.4f", v.num)))
  )

  /** The columns that some of the reports have a figure for. */
  def shown(reports: Seq[ujson.Obj]): Seq[Column] = columns.filter(c => reports.exists(c.show(_) != "-"))

  def apply(reports: Seq[ujson.Obj]): String = {
    val rows = ("scene" +: columns.map(_.heading)) +: reports.map(r => r("scene").str +: columns.map(_.show(r)))
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
