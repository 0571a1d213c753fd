package frustum.command.play

import frustum.command.pong.PongScenes
import frustum.contract.raster.RasterConfig
import frustum.contract.video.VideoMode
import frustum.driver.raster.PreparedFrame
import frustum.engine.pong.{PongBoard, PongEngines, PongFrame, PongSetting}
import frustum.engine.raster.{EngineOptions, RasterEngines, RenderedFrame}
import frustum.harness.Simulated
import frustum.model.demos.pong.{PongButtons, PongGame, PongModel}
import frustum.picture.Picture
import frustum.play.{PlayScreen, PointerMoves, PressedKeys, RasterView}
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite
import java.awt.event.KeyEvent._
import scala.collection.mutable.ArrayBuffer

/** What is played, on a screen that only keeps what it is shown. */
class HeadlessPlayTest extends AnyFunSuite {

  /** @param acts what hands do before the n-th picture */
  private final class Kept(acts: (Int, PressedKeys) => Unit, mouse: Int => PointerMoves = _ => PointerMoves())
      extends PlayScreen {
    private val pressed = new PressedKeys
    private var looks = 0
    val pictures = ArrayBuffer.empty[Array[Int]]
    val states = ArrayBuffer.empty[String]
    acts(0, pressed)
    def isOpen: Boolean = true
    def keys(): Set[Int] = pressed.take()
    override def pointer(): PointerMoves = { looks += 1; mouse(looks - 1) }
    def show(rgb: Array[Int], state: String): Unit = {
      pictures += rgb.clone
      states += state
      acts(pictures.length, pressed)
    }
    def framesPerSecond: Double = 29.75
  }

  private val config = PongScenes.config(VideoMode.Vga640x480, None)
  private def pong(screen: Kept, frames: Int): Option[PongFrame] =
    PlayPong.play(config, screen, Some(frames), None) { buttons: Iterator[PongButtons] => (each: PongFrame => Unit) =>
      PongEngines.byName("model").make(PongSetting(config, PongBoard.Icebreaker, 1)).draw(buttons)(each)
    }

  test("pong: two taps of a key within one frame move the paddle by two steps") {
    val screen = new Kept((shown, keys) =>
      if (shown == 2) for (at <- Seq(0L, 60L)) { keys.press(VK_RIGHT, at); keys.release(VK_RIGHT, at + 30) }
    )
    val frames = 14
    assert(pong(screen, frames).exists(_.index == frames - 1))
    val still = Iterator.iterate(PongGame.start)(_.tick(PongButtons())).drop(frames / 2).next()
    val paddle = 2 * frustum.demos.pong.PongRules.PaddleStep
    val due = Picture.ofFormat(new PongModel(config).frame(still.copy(paddleX = paddle)), config.format)
    assert(screen.pictures.last.sameElements(due))
    assert(screen.states.forall(_ == "50 % of the board's speed - score 0"), screen.states)
  }

  test("pong: a key that is held moves the paddle in every tick") {
    val screen = new Kept((shown, keys) => if (shown == 0) keys.press(VK_UP, 0))
    pong(screen, 9)
    val game = Iterator.iterate(PongGame.start)(_.tick(PongButtons(up = true))).drop(4).next()
    assert(screen.pictures.last.sameElements(Picture.ofFormat(new PongModel(config).frame(game), config.format)))
  }

  private val small = RasterConfig(width = 64, height = 48)
  private def raster(screen: Kept, frames: Int, engine: String = "model"): Int =
    PlayRaster.play(RasterView(Scenes.byName("cube"), 64.0 / 48), small, screen, Some(frames)) {
      works: Iterator[PreparedFrame] => (each: RenderedFrame => Unit) =>
        RasterEngines.byName(engine).make(EngineOptions(1, None, live = true)).draw(works)(each)
    }

  for ((engine, marks) <- Seq("model" -> Nil, "pipeline" -> Seq(Simulated), "hardware" -> Seq(Simulated)))
    test(s"raster: a mesh stands still, turns, is lit, engine $engine", marks: _*) {
      val screen = new Kept(
        (shown, keys) =>
          shown match {
            case 4 => keys.press(VK_L, 0)
            case _ =>
          },
        look => PointerMoves(dragX = if (look == 2) 40 else 0)
      )
      assert(raster(screen, 6, engine) == 6)
      val Seq(first, second, turned, stays, lit, _) = screen.pictures.map(_.toSeq).toSeq
      assert(first.distinct.length > 2 && first == second && turned != second && turned == stays && lit != stays)
      assert(screen.states.map(_.contains("light on")) == Seq(false, false, false, false, true, true))
    }

  test("raster: a view that cannot be drawn is told, and the one before stays") {
    val cube = Scenes.byName("cube")
    val screen = new Kept((_, _) => (), look => PointerMoves(wheel = if (look == 1) Double.NaN else 0))
    val shown = PlayRaster.play(RasterView(cube, 64.0 / 48), small, screen, Some(3)) { works => each =>
      RasterEngines.byName("model").make(EngineOptions(1, None, live = true)).draw(works)(each)
    }
    assert(shown == 3 && screen.states(1).startsWith("not drawn: ") && screen.states(2) == "light off", screen.states)
    assert(screen.states(1).contains("is not finite") && screen.pictures.map(_.toSeq).distinct.length == 1)
  }
}
