package frustum.model.video

import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel

/** What goes to the display, see [[frustum.video.SpiDisplay]]: bytes, each with D/C (true: data). */
object SpiDisplay {
  final case class Pixel(color: Int, first: Boolean, tileX: Int, tileY: Int)

  def start(config: RasterConfig, panel: Panel): Seq[(Boolean, Int)] =
    panel.start(config).flatMap(c => (false, c.code) +: c.parameters.map((true, _)))

  def tiles(config: RasterConfig, panel: Panel, pixels: Seq[Pixel]): Seq[(Boolean, Int)] = pixels.flatMap { p =>
    val window = if (p.first) windowOf(config, panel, p.tileX, p.tileY) else Nil
    window ++ word(p.color)
  }

  private def word(v: Int): Seq[(Boolean, Int)] = Seq((true, v >> 8), (true, v & 255))

  private def windowOf(config: RasterConfig, panel: Panel, tileX: Int, tileY: Int): Seq[(Boolean, Int)] = {
    val (column, row) = panel.origin(config)
    def range(tile: Int, size: Int, pixels: Int, origin: Int) =
      word(origin + tile * size) ++ word(origin + (tile * size + size).min(pixels) - 1)
    ((false, Panel.ColumnAddress) +: range(tileX, config.tileWidth, config.width, column)) ++
      ((false, Panel.RowAddress) +: range(tileY, config.tileHeight, config.height, row)) :+ ((false, Panel.MemoryWrite))
  }
}
