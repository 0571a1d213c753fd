package frustum.engine.pong

import frustum.contract.video.VideoMode
import frustum.demos.pong.{PongPipelineConfig, PongScene}
import frustum.harness.{Simulated, ThreadTime}
import frustum.model.demos.pong.{PongButtons, PongModel}
import frustum.play.{AutoPlayer, PlayedGame}
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** The model as an engine: what the hardware shows, whenever buttons are pressed. */
class PongModelEngineTest extends AnyFunSuite {
  private val config = PongPipelineConfig(
    VideoMode("small", 25, 256, 96, 16, 96, 400, 2, 2, 30, hPositive = true, vPositive = false),
    scene = PongScene.room(256, 96, 3)
  )
  private def draw(engine: String, buttons: Seq[PongButtons]): Seq[PongFrame] =
    PongEngines.byName(engine).make(PongSetting(config, PongBoard.Arty, 1)).drawAll(buttons)

  test("a game that is played tick by tick") {
    val (shown, buttons) = PlayedGame.frames(AutoPlayer(_)).take(40).toSeq.unzip
    val model = new PongModel(config)
    val frames = draw("model", buttons)
    assert(frames.map(_.index) == frames.indices)
    for ((frame, game) <- frames.zip(shown)) assert(frame.atPins.sameElements(model.frame(game)), frame.index)
  }

  test("640 x 480 in real time: 30 pictures take less than a second of one core") {
    val vga = PongPipelineConfig()
    val buttons = PlayedGame.frames(AutoPlayer(_)).take(240).map(_._2).toSeq // a picture is shown for two frames
    def seconds(pictures: Int) = ThreadTime.of(
      PongEngines.byName("model").make(PongSetting(vga, PongBoard.Arty, 1))
        .draw(buttons.take(2 * pictures).iterator)(_ => ())
    )._1
    seconds(60) // compiled meanwhile
    val room = seconds(1)
    val rate = 119 / (seconds(120) - room)
    info(f"$rate%.0f pictures per second of one core, after $room%.1f s for the empty room and the first one")
    assert(rate > 30)
  }

  test("buttons that change from frame to frame: what the hardware shows", Simulated) {
    val seed = 9
    val random = new Random(seed)
    def button() = random.nextInt(3) == 0
    val buttons = Seq.fill(24)(PongButtons(button(), button(), button(), button()))
    for ((is, due) <- draw("model", buttons).zip(draw("hardware", buttons)))
      assert(is.atPins.sameElements(due.atPins) && is.score == due.score, s"frame ${is.index}, seed $seed")
  }
}
