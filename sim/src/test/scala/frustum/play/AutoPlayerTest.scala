package frustum.play

import frustum.model.demos.pong.PongGame
import org.scalatest.funsuite.AnyFunSuite

class AutoPlayerTest extends AnyFunSuite {
  test("wins the game") {
    val game = Iterator.iterate(PongGame.start)(g => g.tick(AutoPlayer(g))).take(20000).find(_.over)
    assert(game.exists(g => g.won && g.score == 63), s"$game")
  }
}
