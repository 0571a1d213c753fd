package frustum.contract.video

/** The crosshair in a picture's middle: 13 pixels whose colours are inverted. */
final case class Crosshair(width: Int, height: Int) {
  val x: Int = width / 2
  val y: Int = height / 2

  def covers(i: Int, j: Int): Boolean =
    i == x && (j - y).abs <= Crosshair.Arm || j == y && (i - x).abs <= Crosshair.Arm
}

object Crosshair { val Arm = 3 }
