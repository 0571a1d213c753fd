package frustum.command.render

import frustum.contract.raster.RasterConfig
import frustum.driver.raster.PreparedFrame
import frustum.engine.raster.{EngineOptions, Frames, RasterEngineEntry, RasterEngines, RenderedFrame}
import frustum.engine.{Engine, EngineKind}
import frustum.harness.Simulated
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite
import java.io.ByteArrayOutputStream
import scala.collection.mutable.ArrayBuffer

/** Animations: frame by frame through engine and judges, none kept. */
class SceneRunTest extends AnyFunSuite {
  private val small = RasterConfig(width = 64, height = 48)

  private def run(entry: RasterEngineEntry, frames: Int) =
    SceneRun.still(Scenes.byName("cube"), small, entry, EngineOptions(1, None)).copy(frames = frames, turnDegrees = 20)

  private def quietly[A](body: => A): (A, Seq[String]) = {
    val out = new ByteArrayOutputStream
    val result = Console.withOut(out)(body)
    (result, out.toString.linesIterator.toSeq)
  }

  test("a frame is judged and handed over before the next is prepared; progress is told with it") {
    val events = ArrayBuffer.empty[String]
    val model = RasterEngines.byName("model").make(EngineOptions(1, None))
    val watched = new Engine[PreparedFrame, RenderedFrame] {
      def draw(works: Iterator[PreparedFrame])(each: RenderedFrame => Unit): Unit =
        model.draw(works.map { w => events += s"take ${w.passes.head.frame}"; w })(each)
    }
    val entry = new RasterEngineEntry("model", EngineKind.Model)(_ => watched)
    val (figures, said) = quietly(run(entry, 4).figures { (frame, _) => events += s"hand over $frame" })
    assert(events.toSeq == (0 until 4).flatMap(n => Seq(s"take $n", s"hand over $n")))
    assert(figures.frames.length == 4 && figures.failures.isEmpty)
    assert(said.filter(_.contains(" of 4")) == (1 to 4).map(n => s"cube: $n of 4"))
  }

  for ((name, ahead) <- Seq("pipeline" -> 3, "hardware" -> 3))
    test(s"engine $name hands frames over while later ones are not taken yet, and all are the model's", Simulated) {
      val frames = Frames.scene("cube", small, frames = 8)
      var (taken, shown) = (0, 0)
      RasterEngines.byName(name).make(EngineOptions(1, None)).draw(frames.iterator.map { f => taken += 1; f }) {
        drawn =>
          Frames.assertEqual(small, drawn.image, Frames.model(frames(shown)), s"frame $shown")
          assert(drawn.clocks.isDefined && drawn.clocksAtPins.isDefined == (name == "hardware"))
          shown += 1
          assert(taken <= shown + ahead, s"$taken taken, $shown shown")
      }
      assert(shown == 8)
    }

  for (name <- Seq("pipeline", "hardware"))
    test(s"engine $name that is played takes a frame when the one before is shown", Simulated) {
      val frames = Frames.scene("cube", small, frames = 3)
      var (taken, shown) = (0, 0)
      RasterEngines.byName(name).make(EngineOptions(1, None, live = true)).draw(
        frames.iterator.map { f => taken += 1; f }
      ) { drawn =>
        Frames.assertEqual(small, drawn.image, Frames.model(frames(shown)), s"frame $shown")
        shown += 1
        assert(taken == shown)
      }
      assert(shown == 3)
    }
}
