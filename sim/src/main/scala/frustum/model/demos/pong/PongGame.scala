package frustum.model.demos.pong

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.RayMotion
import frustum.demos.pong.PongRules._

final case class PongButtons(
    up: Boolean = false,
    down: Boolean = false,
    left: Boolean = false,
    right: Boolean = false
) {

  /** All at once begin a new game. */
  def restart: Boolean = up && down && left && right
}

/** One axis of the puck: speed is a magnitude. */
final case class PuckAxis(position: Int, speed: Int, positive: Boolean) {

  /** A tick: beyond a limit it is set to the limit and turns, in the same tick. */
  def move(low: Int, high: Int): PuckAxis = {
    val to = if (positive) position + speed else position - speed
    if (to > high) PuckAxis(high, speed, positive = false)
    else if (to < low) PuckAxis(low, speed, positive = true)
    else copy(position = to)
  }
}

/** State of 3-D pong between two ticks, see [[frustum.demos.pong.PongRules]]. */
final case class PongGame(
    puck: Seq[PuckAxis],
    paddleX: Int = 0,
    paddleY: Int = 0,
    score: Int = 0,
    lost: Boolean = false,
    caught: Boolean = false
) {
  def won: Boolean = score == WinScore
  def over: Boolean = won || lost

  private def moved(at: Int, less: Boolean, more: Boolean, limit: Int) = {
    val step = (if (more) PaddleStep else 0) - (if (less) PaddleStep else 0)
    (at + step).max(-limit).min(limit)
  }

  /** Paddle, puck, bounce or catch, score, in this order. After the end nothing moves. */
  def tick(buttons: PongButtons): PongGame =
    if (buttons.restart) PongGame.start
    else if (over) copy(caught = false)
    else {
      val px = moved(paddleX, buttons.left, buttons.right, PaddleX)
      val py = moved(paddleY, buttons.down, buttons.up, PaddleY)
      val Seq(x, y, z) = (0 to 2).map(a => puck(a).move(PuckLow(a), PuckHigh(a)))
      val atWall = puck(2).positive && puck(2).position + puck(2).speed >= PuckHigh.z
      val (dx, dy) = (x.position - px, y.position - py)
      val hit = atWall && dx.abs < Reach && dy.abs < Reach
      if (!atWall) PongGame(Seq(x, y, z), px, py, score)
      else if (!hit) PongGame(Seq(x, y, z.copy(position = PuckHigh.z)), px, py, score, lost = true)
      else
        PongGame(
          Seq(
            PuckAxis(x.position, dx.abs / 2, dx >= 0),
            PuckAxis(y.position, dy.abs / 2, dy >= 0),
            PuckAxis(PuckHigh.z, z.speed + 1, positive = false)
          ),
          px,
          py,
          score + 1,
          caught = true
        )
    }

  /** Where puck and paddle are, for the ray caster of [[frustum.demos.pong.PongScene]]. */
  def motion: RayMotion = RayMotion(
    Seq(IntVector(puck(0).position, puck(1).position, puck(2).position)),
    Seq(IntVector(paddleX, paddleY, PuckHigh.z + PuckRadius))
  )
}

object PongGame {
  val start: PongGame =
    PongGame((0 to 2).map(a => PuckAxis(PuckStart(a), StartSpeed, positive = true)))
}
