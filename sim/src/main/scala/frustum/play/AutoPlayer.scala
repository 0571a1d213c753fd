package frustum.play

import frustum.demos.pong.PongRules._
import frustum.model.demos.pong.{PongButtons, PongGame}

/** Takes the paddle to where the puck will meet the back wall. Caught near the paddle's middle the puck leaves
  * as good as straight and never outruns the paddle; only near the room's corners, out of the paddle's reach,
  * does it get fast, and then the way has to be foreseen.
  */
object AutoPlayer {

  /** Nearer than half a step of the paddle there is nothing to gain. */
  private val Slack = PaddleStep / 2

  /** Buttons for the next tick. */
  def apply(game: PongGame): PongButtons = {
    val (aimX, aimY) = arrival(game)
    val (x, y) = (aimX - game.paddleX, aimY - game.paddleY)
    PongButtons(up = y > Slack, down = y < -Slack, left = x < -Slack, right = x > Slack)
  }

  /** Where the puck next comes to the back wall. */
  private def arrival(game: PongGame): (Int, Int) = {
    var Seq(x, y, z) = game.puck
    do {
      x = x.move(PuckLow.x, PuckHigh.x)
      y = y.move(PuckLow.y, PuckHigh.y)
      z = z.move(PuckLow.z, PuckHigh.z)
    } while (z.position < PuckHigh.z)
    (x.position, y.position)
  }
}
