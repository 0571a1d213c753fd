package frustum.contract.video

/** A line of `length` letters on the screen, enlarged 2^scale times, at a column and a row of the grid of cells of this
  * size.
  */
case class TextField(column: Int, row: Int, length: Int, scale: Int) {
  val cell: Int = Font.Cell << scale
  require(
    column >= 0 && row >= 0 && length > 0 && scale >= 0,
    s"text of $length letters, scale $scale, at column $column, row $row"
  )
}

object TextField {

  /** In the middle of a row. */
  def centred(width: Int, row: Int, length: Int, scale: Int): TextField = {
    val columns = width / (Font.Cell << scale)
    require(
      length <= columns,
      s"$length letters of scale $scale in a picture of $width pixels: at most $columns"
    )
    TextField((columns - length) / 2, row, length, scale)
  }
}
