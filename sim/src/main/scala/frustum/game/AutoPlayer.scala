package frustum.game

import frustum.model.game.{PongButtons, PongGame}
import frustum.spec.{IntVector, RayRoom}

/** Takes the paddle to where the puck will meet the back wall. Caught near the paddle's middle the puck leaves
  * as good as straight and never outruns the paddle; only near the room's corners, out of the paddle's reach,
  * does it get fast, and then the way has to be foreseen.
  *
  * @param room   of the game
  * @param radius of the puck
  */
final class AutoPlayer(room: RayRoom, radius: Int) {
  private val (low, high) = (0 to 2).map(a => (room.low(a) + radius, room.high(a) - radius)).unzip
  private var before      = Option.empty[IntVector]

  /** Buttons for the next tick; to be called once before each. */
  def apply(game: PongGame): PongButtons = {
    val puck = game.puck
    val move = before.fold(IntVector(0, 0, 0))(puck - _)
    before = Some(puck)
    val aim    = arrival(puck, move)
    val (x, y) = (aim.x - game.paddle.x, aim.y - game.paddle.y)
    PongButtons(
      up = y > AutoPlayer.Slack,
      down = y < -AutoPlayer.Slack,
      left = x < -AutoPlayer.Slack,
      right = x > AutoPlayer.Slack
    )
  }

  /** The puck at the back wall, when it goes on as it moved in the last tick. */
  private def arrival(puck: IntVector, move: IntVector): IntVector = {
    val (at, step) = (puck.axes.toArray, move.axes.toArray)
    if (step(2) == 0) puck
    else {
      while (at(2) < high(2)) for (a <- 0 to 2) {
        at(a) += step(a)
        if (at(a) < low(a) || a < 2 && at(a) > high(a)) {
          at(a) = at(a).max(low(a)).min(high(a))
          step(a) = -step(a)
        }
      }
      IntVector(at(0), at(1), at(2))
    }
  }
}

object AutoPlayer {

  /** Nearer than half a step of the paddle there is nothing to gain. */
  private val Slack = 2
}
