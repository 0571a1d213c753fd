package frustum.command.pong

import java.util.Locale

/** The key figures of a report of pong, for the terminal. */
object PongTable {
  private val Keys = Seq(
    "frames",
    "clocksPerFrame",
    "pixelsPerClock",
    "latencyClocks",
    "syncErrors",
    "silhouettePixelsWrong",
    "shadowPixelsWrong",
    "objectPixelsWrong",
    "checkerCellsWrong",
    "maxColourError",
    "psnr",
    "score",
    "win"
  )

  def apply(report: ujson.Obj): String =
    (Keys.map(k => k -> shown(report(k))) :+
      "pixels != model" -> shown(report("hardwareVsModel")("pixelsDifferent")))
      .map { case (key, value) => f"  $key%-22s $value%10s" }.mkString("\n")

  private def shown(v: ujson.Value): String = v match {
    case ujson.Null                   => "equal"
    case ujson.Num(n) if n == n.floor => "%,.0f".formatLocal(Locale.ROOT, n)
    case ujson.Num(n)                 => "%.2f".formatLocal(Locale.ROOT, n)
    case other                        => other.toString
  }
}
