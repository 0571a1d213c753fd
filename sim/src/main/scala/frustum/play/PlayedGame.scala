package frustum.play

import frustum.model.demos.pong.{PongButtons, PongGame}

/** A game of pong as the hardware shows it: the start for one frame, then each tick's state for two. */
object PlayedGame {

  /** The state that each frame shows, and the buttons that are held meanwhile, without end.
    *
    * @param player presses the buttons of the tick that follows a state; called once for each, in order, when its first
    *   frame is due
    */
  def frames(player: PongGame => PongButtons): Iterator[(PongGame, PongButtons)] = {
    val ticks = Iterator.unfold(PongGame.start) { game =>
      val buttons = player(game)
      Some((game, buttons) -> game.tick(buttons))
    }
    ticks.zipWithIndex.flatMap { case (tick, n) => Iterator.fill(if (n == 0) 1 else 2)(tick) }
  }
}
