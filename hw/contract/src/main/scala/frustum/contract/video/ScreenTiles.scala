package frustum.contract.video

/** A screen, and the tiles of 2^n x 2^m pixels in which its pixels are sent. */
trait ScreenTiles {
  def width: Int
  def height: Int
  def tileLog2Width: Int
  def tileLog2Height: Int
}

/** A screen of one tile: rows from the top, pixels from the left. */
final case class WholeScreen(width: Int, height: Int) extends ScreenTiles {
  private def log2(n: Int) = 32 - Integer.numberOfLeadingZeros(n - 1)
  val tileLog2Width: Int = log2(width)
  val tileLog2Height: Int = log2(height)
}
