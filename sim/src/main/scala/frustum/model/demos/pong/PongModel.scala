package frustum.model.demos.pong

import frustum.demos.pong.PongPipelineConfig
import frustum.model.ray.StillCamera
import frustum.model.video.{DitheredScreen, TextOverlay}

/** Bit-exact model of [[frustum.demos.pong.PongPipeline]]: the picture of a state of the game. */
class PongModel(config: PongPipelineConfig) {
  import config.mode
  private lazy val rays = new StillCamera(config.scene, mode.width, mode.height)
  private val screen = new DitheredScreen(mode.width, mode.height, config.format)

  /** What the overlay writes. */
  def text(game: PongGame): TextOverlay = TextOverlay(
    Seq(
      config.score -> Some(f"${game.score}%02d"),
      config.message -> (if (game.won) Some("WIN!") else if (game.lost) Some("LOSE") else None)
    )
  )

  /** Any 24-bit picture, row by row, as it leaves at the pins. */
  def atPins(rgb: Array[Int], game: PongGame): Array[Int] = screen(rgb, text(game))

  def frame(game: PongGame): Array[Int] = atPins(rays(config.motion(game.motion)), game)
}
