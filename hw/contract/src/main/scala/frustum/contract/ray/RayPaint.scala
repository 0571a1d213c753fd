package frustum.contract.ray

/** How a wall or a quad is painted. Cells and texels are squares of 2^bits units, counted from the surface's low
  * corner.
  */
sealed trait RayPaint {

  /** Cell = 2^cellBits units. */
  def cellBits: Int

  /** Lower bits of the cell's number that are used, along the surface's column axis and its row axis. */
  def columnBits: Int
  def rowBits: Int
}

/** One colour, 24-bit RGB. */
case class RaySolid(color: Int) extends RayPaint {
  def cellBits: Int = 0
  val (columnBits, rowBits) = (0, 0)
}

/** On walls alone: red, green, blue where the number of the cell along x, y, z above the room's low corner is odd. */
case class RayChecker(cellBits: Int) extends RayPaint {
  val (columnBits, rowBits) = (1, 1)
  require(
    cellBits >= 0 && cellBits <= RayPaint.MaxCellBits,
    s"checker cells of 2^$cellBits units, at most 2^${RayPaint.MaxCellBits}"
  )
}

/** Nearest texel of an image that repeats: its bottom left corner is the surface's low corner.
  *
  * @param rgb rows from the top, 24 bits per texel
  */
case class RayImage(width: Int, height: Int, cellBits: Int, rgb: IndexedSeq[Int]) extends RayPaint {
  for (n <- Seq(width, height))
    require(
      n >= 1 && n <= RayPaint.MaxSide && Integer.bitCount(n) == 1,
      s"image of $width x $height texels: each side must be a power of two up to ${RayPaint.MaxSide}"
    )
  require(
    cellBits >= 0 && cellBits <= RayPaint.MaxCellBits,
    s"texels of 2^$cellBits units, at most 2^${RayPaint.MaxCellBits}"
  )
  require(rgb.size == width * height, s"${rgb.size} texels for $width x $height")
  val columnBits: Int = Integer.numberOfTrailingZeros(width)
  val rowBits: Int = Integer.numberOfTrailingZeros(height)

  /** Texel of a column and of a row counted from the bottom, both modulo the image's size. */
  def texel(column: Int, row: Int): Int =
    rgb((height - 1 - (row & (height - 1))) * width + (column & (width - 1)))
}

object RayPaint {
  val MaxCellBits = 12
  val MaxSide = 256
}
