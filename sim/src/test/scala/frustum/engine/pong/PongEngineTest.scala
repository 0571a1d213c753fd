package frustum.engine.pong

import frustum.contract.arithmetic.IntVector
import frustum.contract.ray.{RayQuad, RayScene, RaySolid, RaySphere}
import frustum.contract.video.VideoMode
import frustum.demos.pong.{PongPipelineConfig, PongScene}
import frustum.harness.Simulated
import frustum.model.demos.pong.{PongButtons, PongGame, PongModel}
import frustum.play.{AutoPlayer, PlayedGame}
import org.scalatest.funsuite.AnyFunSuite

/** Games at the pins of the boards' tops, in modes of few pixels: each frame is the model's. */
class PongEngineTest extends AnyFunSuite with Simulated {

  /** The room in few pixels, and blanks that are long enough for set-up.
    *
    * @param scene of a room
    */
  private def config(width: Int, height: Int, pixel: Int, hBack: Int = 400, vBack: Int = 30)(
      scene: RayScene => RayScene
  ) = PongPipelineConfig(
    VideoMode("small", 25, width, height, 16, 96, hBack, 2, 2, vBack, hPositive = true, vPositive = false),
    scene = scene(PongScene.room(width, height, pixel))
  )

  /** Frames are compared as they come: a state's two are one picture. */
  private def play(c: PongPipelineConfig, player: PongGame => PongButtons, frames: Int, board: PongBoard) = {
    val model = new PongModel(c)
    var last = Option.empty[(PongGame, Seq[Int])]
    val (shown, played) = PlayedGame.frames(player).take(frames).duplicate
    var run = Option.empty[PongMeasures]
    PongEngines.default.make(PongSetting(c, board, 1)).draw(played.map(_._2)) { f =>
      val game = shown.next()._1
      val wanted = last.filter(_._1 == game).fold(model.frame(game).toSeq)(_._2)
      last = Some((game, wanted))
      assert(f.atPins.toSeq == wanted, s"frame ${f.index}")
      run = f.measures
    }
    assert(run.get.frames == frames && run.get.syncErrors == 0)
    run.get
  }

  test("arty-pong: pictures at the pins, timing, buttons") {
    val run = play(config(256, 96, 3)(identity), _ => PongButtons(up = true, right = true), 8, PongBoard.Arty)
    assert(run.pixelsPerClock == 1 && run.clocksPerFrame == (256 + 512) * (96 + 34))
  }

  test("seven spheres and three quads that stand still") {
    def add(s: RayScene) = s.copy(
      spheres = s.spheres ++ (0 to 6).map { i =>
        val at = IntVector(-180 + 60 * i, 40 * (i % 3) - 40, -60 - 20 * (i % 2))
        RaySphere(at, at, 12 + i, 0x204060 * (i % 4) + 0x30)
      },
      quads = s.quads ++ Seq((-200, 100), (0, -120), (220, 0)).map { case (x, y) =>
        RayQuad(IntVector(x, y, 640), IntVector(x, y, 640), 30, RaySolid(0x40c080))
      }
    )
    // rows as long as the next row's steps
    play(config(1600, 64, 1, hBack = 2000, vBack = 60)(add), AutoPlayer(_), 2, PongBoard.Icebreaker)
  }
}
