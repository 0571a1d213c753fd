package frustum.command.report

import frustum.command.common.{Figure, Page}

/** Figures of `bench`, a table for each that was run. */
object BenchPart extends ReportPart("Cycles of standard loads", "bench", "bench raster") {
  def shown(files: ReportFiles): Option[Shown] = {
    val tables = files.ofKind(".json").map(f => files.read(f)(table(f.getFileName.toString.stripSuffix(".json"), _)))
    Option.when(tables.nonEmpty)(
      Shown(tables.mkString("\n"), s"${tables.length} measured", good = true, files.ofKind(".json"))
    )
  }

  private val Names = Map(
    "fullScreenClocksPerPixel" -> "whole screen, textured, depth-tested and blended: cycles per pixel",
    "fullScreenBilinearClocksPerPixel" -> "the same with the bilinear filter: cycles per pixel",
    "setupClocks" -> "set-up of a triangle: cycles",
    "tileRebaseClocks" -> "moving a triangle to a further tile: cycles",
    "rightTriangleClocks" -> "right triangle with legs of so many pixels: cycles",
    "randomIn16Clocks" -> "random triangle within 16 x 16 pixels: cycles",
    "diagonalSliverClocks" -> "diagonal sliver: cycles",
    "needleClocksPerPixel" -> "needle: cycles per pixel",
    "bytesPerTriangle" -> "closed mesh: bytes per triangle",
    "cubeClocksPerFrame" -> "textured cube: cycles per frame",
    "textureUploadClocks" -> "upload of a 64 x 64 texture: cycles",
    "clearClocksPerFrame" -> "empty frame: cycles",
    "clocksPerFrame" -> "scene: cycles per frame"
  )

  /** What tells of the run, not of the hardware. */
  private val Others = Set("command", "version", "seed", "engine", "positions")

  private def table(name: String, report: ujson.Obj): String = {
    val rows = report.value.toSeq.filterNot(f => Others(f._1)).flatMap {
      case (key, v: ujson.Obj) => v.value.toSeq.flatMap { case (of, n) => value(n).map(Seq(s"${called(key)}, $of", _)) }
      case (key, v)            => value(v).map(Seq(called(key), _))
    }
    s"<section><h2>${Page.escape(name)}</h2>\n${Page.table(Seq("load", "measured"), rows)}</section>"
  }

  private def value(v: ujson.Value) = v.numOpt.map(Figure(_))
  private def called(key: String) = Page.escape(Names.getOrElse(key, Figure.words(key)))
}
