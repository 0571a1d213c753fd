package frustum.judge

import frustum.contract.ray.RayMotion
import frustum.demos.pong.PongPipelineConfig
import frustum.model.demos.pong.{PongGame, PongModel}
import frustum.model.ray.RayPicture
import scala.concurrent.ExecutionContext.Implicits.global
import scala.concurrent.duration.Duration
import scala.concurrent.{Await, Future}

/** Judges frames of pong while the next are drawn: at the pins against the bit-exact model, and the model's
  * picture, which tells objects too, against exact arithmetic. Neighbouring frames of one state share the work.
  */
final class PongJudge(config: PongPipelineConfig) {
  import config.{mode, scene}

  /** A model keeps the state of its set-up: one for each thread. */
  private val rays = ThreadLocal.withInitial(() => new RayPicture(scene, mode.width, mode.height))
  private val model = new PongModel(config)
  private val judge = new RayJudge(scene, mode.width, mode.height)

  private case class Expected(atPins: Array[Int], counts: RayCounts)
  private var last = Option.empty[(PongGame, Future[Expected])]
  private var pending = Vector.empty[Future[PongFigures]]
  private var sum = PongFigures.none

  private def expect(game: PongGame): Future[Expected] = last.filter(_._1 == game).map(_._2).getOrElse {
    val made = Future {
      val motion = config.motion(game.motion)
      val pixels = rays.get()(motion)
      val rgb = pixels.map(_.rgb)
      Expected(model.atPins(rgb, game), judge(motion, pixels.map(_.objectId), rgb))
    }
    last = Some((game, made))
    made
  }

  /** @param game the state that the frame is to show */
  def add(game: PongGame, atPins: Array[Int]): Unit = {
    pending :+= expect(game).map { e =>
      PongFigures(1, e.atPins.indices.count(i => e.atPins(i) != atPins(i)), e.counts)
    }
    // So that no more than a few pictures are kept.
    while (pending.size > PongJudge.Ahead) take()
  }

  private def take(): Unit = {
    sum = sum + Await.result(pending.head, Duration.Inf)
    pending = pending.tail
  }

  /** Of all frames so far. */
  def figures(): PongFigures = {
    while (pending.nonEmpty) take()
    sum
  }
}

object PongJudge {
  private val Ahead = 2 * Runtime.getRuntime.availableProcessors

  /** The exact picture of a state, 0xRRGGBB. */
  def reference(config: PongPipelineConfig, motion: RayMotion): Array[Int] = {
    val exact = new frustum.reference.ray.ExactRay(config.scene)
    Array.tabulate(config.mode.width * config.mode.height) { i =>
      exact(motion, i % config.mode.width, i / config.mode.width).rgb
        .foldLeft(0)((word, c) => word << 8 | scala.math.round(c).toInt)
    }
  }
}
