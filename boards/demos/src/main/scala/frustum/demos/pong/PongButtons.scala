package frustum.demos.pong

import spinal.core._

/** Four directions; opposite ones cancel each other, all four together begin a new game. */
case class PongButtons() extends Bundle {
  val up, down, left, right = Bool()
  def restart: Bool = up && down && left && right
}
