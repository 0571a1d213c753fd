package frustum.judge

import frustum.contract.video.VideoMode
import frustum.demos.pong.{PongPipelineConfig, PongScene}
import frustum.model.demos.pong.{PongButtons, PongGame, PongModel}
import org.scalatest.funsuite.AnyFunSuite

class PongJudgeTest extends AnyFunSuite {
  private val mode =
    VideoMode("256x96", 25.175, 256, 96, 16, 96, 400, 10, 2, 33, hPositive = true, vPositive = false)
  private val config = PongPipelineConfig(mode, scene = PongScene.room(256, 96, 3))
  private val model = new PongModel(config)
  private val moved = PongGame.start.tick(PongButtons(up = true))

  private def judge(frames: (PongGame, Array[Int])*): PongFigures = {
    val judge = new PongJudge(config)
    frames.foreach { case (game, atPins) => judge.add(game, atPins) }
    judge.figures()
  }

  test("the model's own frames are without fault") {
    val f = judge(Seq(PongGame.start, PongGame.start, moved).map(g => g -> model.frame(g)): _*)
    assert(f.frames == 3 && f.rays.pixels == 3 * 256 * 96 && f.failures.isEmpty, f)
  }

  test("a pixel that differs, and a frame of another tick, are seen") {
    val wrong = model.frame(moved)
    wrong(1234) ^= 1
    val f = judge(PongGame.start -> model.frame(PongGame.start), moved -> wrong)
    assert(f.pixelsDifferent == 1 && f.failures == Seq("1 pixels differ from the model's"))
    assert(judge(moved -> model.frame(PongGame.start)).pixelsDifferent > 0)
  }

  test("sums, and what must be zero") {
    val one = PongFigures(
      1,
      7,
      RayCounts(100, 1, 2, 3, 4, 5.5, 6, squaredError = 255.0 * 255 * 3 * 100 / 1000)
    ) // 30 dB
    val sum = one + PongFigures(1, 0, RayCounts(100, 0, 0, 0, 0, 1.5, 0, squaredError = 0))
    assert(sum.failures.map(_.takeWhile(_ != ' ')) == Seq("7", "1", "2", "3", "4"))
    assert(sum.frames == 2 && sum.rays.maxColourError == 5.5 && sum.rays.colourErrorsOver1 == 6)
    assert(
      (one.rays.psnr.get - 30).abs < 1e-9 && (sum.rays.psnr.get - 30 - 10 * scala.math.log10(2)).abs < 1e-9
    )
  }
}
