package frustum.model.video

import frustum.contract.video.ColorFormat

/** A picture with text over it as it leaves at the pins: [[TextOverlay]], then [[OrderedDither]], of a whole picture
  * at a time.
  */
final class DitheredScreen(width: Int, height: Int, format: ColorFormat) {

  /** By row and column modulo 4, channel and its value: the channel's bits in their place. */
  private val tables: Array[Array[Array[Int]]] = Array.tabulate(4 * 4, 3) { (place, c) =>
    val bits = format.channels(c)
    val shift = format.channels.drop(c + 1).sum
    Array.tabulate(256)(v => OrderedDither.channel(v, bits, place & 3, place >> 2) << shift)
  }

  /** @param rgb 0xRRGGBB, row by row; left as it is */
  def apply(rgb: Array[Int], text: TextOverlay): Array[Int] = {
    require(rgb.length == width * height, s"${rgb.length} pixels for a picture of $width x $height")
    val written = rgb.clone
    for ((field, Some(_)) <- text.fields) {
      val rows = field.row * field.cell until ((field.row + 1) * field.cell min height)
      val columns = field.column * field.cell until ((field.column + field.length) * field.cell min width)
      for (y <- rows; x <- columns) written(y * width + x) = text(rgb(y * width + x), x, y)
    }
    val out = new Array[Int](rgb.length)
    var y = 0
    while (y < height) {
      var x = 0
      while (x < width) {
        val table = tables((y & 3) << 2 | x & 3)
        val color = written(y * width + x)
        out(y * width + x) = table(0)(color >> 16 & 255) | table(1)(color >> 8 & 255) | table(2)(color & 255)
        x += 1
      }
      y += 1
    }
    out
  }
}
