package frustum.model.demos.pong

import frustum.demos.pong.PongPipelineConfig
import frustum.model.ray.RayPicture
import frustum.model.video.{OrderedDither, TextOverlay}

/** Bit-exact model of [[frustum.demos.pong.PongPipeline]]: the picture of a state of the game. */
class PongModel(config: PongPipelineConfig) {
  import config.mode
  private lazy val rays = new RayPicture(config.scene, mode.width, mode.height)

  /** What the overlay writes. */
  def text(game: PongGame): TextOverlay = TextOverlay(
    Seq(
      config.score -> Some(f"${game.score}%02d"),
      config.message -> (if (game.won) Some("WIN!") else if (game.lost) Some("LOSE") else None)
    )
  )

  /** Any 24-bit picture, row by row, as it leaves at the pins. */
  def atPins(rgb: Int => Int, game: PongGame): Array[Int] = {
    val overlay = text(game)
    Array.tabulate(mode.width * mode.height) { i =>
      val (x, y) = (i % mode.width, i / mode.width)
      OrderedDither(overlay(rgb(i), x, y), config.format, x, y)
    }
  }

  def frame(game: PongGame): Array[Int] = {
    val pixels = rays(config.motion(game.motion))
    atPins(i => pixels(i).rgb, game)
  }
}
