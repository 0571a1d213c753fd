package frustum.game

import frustum.model.game.PongGame
import frustum.spec.PongScene
import org.scalatest.funsuite.AnyFunSuite

class AutoPlayerTest extends AnyFunSuite {
  test("wins the game") {
    val scene  = PongScene.room()
    val game   = new PongGame
    val player = new AutoPlayer(scene.room, scene.spheres.head.radius)
    val ticks  = Iterator.continually(game.tick(player(game))).take(20000).indexWhere(_ => game.won || game.missed)
    assert(game.won && !game.missed && game.score == 63, s"score ${game.score} after $ticks ticks")
  }
}
