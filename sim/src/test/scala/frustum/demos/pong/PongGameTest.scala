package frustum.demos.pong

import frustum.demos.pong.PongRules._
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.demos.pong.{PongButtons => Pressed, PongGame => Model, PuckAxis => Axis}
import frustum.play.AutoPlayer
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._

import scala.util.Random

class PongGameTest extends AnyFunSuite {
  private val seed = 20080301

  private def anyButtons(random: Random) =
    Pressed(random.nextBoolean(), random.nextBoolean(), random.nextBoolean(), random.nextInt(4) == 0)

  /** Steers the paddle's centre to the puck's. */
  private def follow(game: Model): Pressed = {
    def off(a: Int, at: Int) = game.puck(a).position - at
    val (dx, dy) = (off(0, game.paddleX), off(1, game.paddleY))
    Pressed(up = dy > 2, down = dy < -2, left = dx < -2, right = dx > 2)
  }

  private def inside(game: Model, hint: => String): Unit = for (a <- 0 to 2) {
    val at = game.puck(a).position
    assert(at >= PuckLow(a) && at <= PuckHigh(a), s"axis $a at $at, $hint")
  }

  test("the puck never leaves the room, the paddle its reach, in 10,000 random games") {
    val random = new Random(seed)
    for (n <- 0 until 10000) {
      var game = Model.start
      val skill = random.nextInt(3)
      var tick = 0
      while (!game.over && tick < 2000) {
        game = game.tick(if (random.nextInt(3) <= skill) follow(game) else anyButtons(random))
        inside(game, s"game $n, tick $tick, seed $seed")
        assert(game.paddleX.abs <= PaddleX && game.paddleY.abs <= PaddleY && game.score <= WinScore)
        tick += 1
      }
    }
  }

  test("63 is reached by a player who foresees the puck, and ends the game") {
    val games = Iterator.iterate(Model.start)(g => g.tick(AutoPlayer(g))).take(40000).takeWhile(g =>
      !g.over || g.caught
    )
    val last = games.reduce((_, g) => g)
    assert(last.won && !last.lost && last.score == WinScore && last.puck(2).speed == StartSpeed + WinScore)
    assert(last.tick(Pressed(up = true)) == last.copy(caught = false))
  }

  test("beyond a limit the puck is set to it and turns in the same tick; speed stays a magnitude") {
    val game = Model.start.copy(puck = Seq(Axis(299, 24, true), Axis(-219, 5, false), Axis(21, 66, false)))
    assert(game.tick(Pressed()).puck == Seq(Axis(300, 24, false), Axis(-220, 5, true), Axis(20, 66, true)))
  }

  test("back wall: strict reach, new speeds from the distance, z faster, one tick of catch") {
    def at(x: Int, y: Int, z: Int = 617) =
      Model.start.copy(puck = Seq(Axis(x, 0, true), Axis(y, 0, true), Axis(z, 3, true)))
    val caught = at(-49, 48).tick(Pressed())
    assert(caught.caught && caught.score == 1)
    assert(caught.puck == Seq(Axis(-49, 24, false), Axis(48, 24, true), Axis(620, 4, false)))
    assert(!caught.tick(Pressed()).caught && caught.tick(Pressed()).score == 1)
    for ((x, y) <- Seq((50, 0), (0, -50))) {
      val missed = at(x, y).tick(Pressed())
      assert(missed.lost && missed.score == 0)
      assert(missed.tick(Pressed(up = true)) == missed, "after a miss paddle and puck stand still")
    }
    assert(!at(200, 0, 616).tick(Pressed()).over, "619 is before the wall")
  }

  test("opposite buttons cancel; all at once begin anew") {
    assert(Model.start.tick(Pressed(up = true, down = true)).paddleY == 0)
    assert(Model.start.copy(score = 5, lost = true).tick(Pressed(true, true, true, true)) == Model.start)
  }

  test("hardware = model, tick by tick, reset at any time", Simulated) {
    FrustumSim.compile("PongGame")(PongGame()).doSim("ticks", seed) { dut =>
      SimTimeout(100L * 1000 * 1000)
      val random = new Random(seed)
      dut.io.tick #= false
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSampling(5)
      var game = Model.start
      def reset(): Unit = {
        dut.clockDomain.assertReset()
        dut.clockDomain.waitRisingEdge(2)
        dut.clockDomain.deassertReset()
        dut.clockDomain.waitSampling()
        game = Model.start
      }
      var wins = 0
      var losses = 0
      for (n <- 0 until 20000) {
        val b = random.nextInt(if (wins == 0) 100000 else 40) match {
          case 0 => Pressed(true, true, true, true)
          case 1 => anyButtons(random)
          case _ => if (losses > 0 && wins == 0) AutoPlayer(game) else follow(game)
        }
        dut.io.buttons.up #= b.up
        dut.io.buttons.down #= b.down
        dut.io.buttons.left #= b.left
        dut.io.buttons.right #= b.right
        dut.io.tick #= true
        dut.clockDomain.waitSampling()
        dut.io.tick #= false
        dut.clockDomain.waitSampling(random.nextInt(PongGame.TickClocks))
        if (random.nextInt(3000) == 0 && wins > 0) reset()
        else {
          dut.clockDomain.waitSampling(PongGame.TickClocks)
          game = game.tick(b)
        }
        val seen = (
          dut.io.puck.map(_.toInt),
          (dut.io.paddleX.toInt, dut.io.paddleY.toInt),
          dut.io.tens.toInt * 10 + dut.io.ones.toInt,
          (dut.io.won.toBoolean, dut.io.lost.toBoolean, dut.io.caught.toBoolean)
        )
        val want = (
          game.puck.map(_.position),
          (game.paddleX, game.paddleY),
          game.score,
          (game.won, game.lost, game.caught)
        )
        assert(seen == want, s"tick $n, $b, seed $seed")
        if (game.won && game.caught) wins += 1
        if (game.lost) losses += 1
        if (game.over && n % 50 == 0) reset()
      }
      assert(wins > 0 && losses > 0, s"$wins wins, $losses losses")
    }
  }
}
