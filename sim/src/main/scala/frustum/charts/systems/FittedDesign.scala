package frustum.charts.systems

import frustum.contract.raster.{FixedBits, FixedState, PlaneFormats, RasterConfig, VertexRanges}
import frustum.driver.raster.DrawOptions
import java.nio.file.{Files, Path}
import scala.util.Try

/** An answer of `fit`, as its report tells it. */
final case class FittedDesign(configuration: SystemConfiguration, placed: Option[Placed])

object FittedDesign {
  val Reports: Path = Path.of("out", "fit")

  /** The answer for a scene, if there is a report of it for a screen of this size.
    *
    * @param options as the scene is drawn elsewhere
    */
  def read(scene: String, base: RasterConfig, options: DrawOptions, reports: Path = Reports): Option[FittedDesign] = {
    val file = reports.resolve(s"$scene.json")
    if (!Files.isRegularFile(file)) None
    else
      Try {
        val report = ujson.read(Files.readString(file))
        val config = configOf(report("configuration"), base)
        val c = report("configuration")
        val drawn = options.copy(cullBack = c("cullBack").bool, depthTest = c("depthTest").bool)
        val budget = report("budget")("texelsWrongPercent").num
        val placed = report.obj.get("logicCells").map(cells =>
          Placed(Some(cells.num.toInt), report.obj.get("clockMHz").map(_.num), s"report $file")
        )
        val setting = s"within ${BigDecimal(budget)} % of texels"
        FittedDesign(SystemConfiguration(SystemConfiguration.Fitted, setting, config, drawn), placed)
      }.toOption.filter(f => f.configuration.config.width == base.width && f.configuration.config.height == base.height)
  }

  private def configOf(c: ujson.Value, base: RasterConfig): RasterConfig = {
    def n(key: String) = c(key).num.toInt
    base.copy(
      width = n("width"),
      height = n("height"),
      textureTexels = n("textureTexels"),
      maxVertices = n("maxVertices"),
      maxTriangles = n("maxTriangles"),
      fixed = FixedState(c("fixed").obj.toMap.map { case (field, bits) =>
        field -> FixedBits(bits("mask").num.toInt, bits("value").num.toInt)
      }),
      formats = PlaneFormats(n("coordinate"), n("depth"), n("color"), n("inverse")),
      ranges = VertexRanges(n("positionBits"), n("repeatBits"), n("ratioBits")),
      clearColor = c("clearColor").numOpt.map(_.toInt)
    )
  }
}
