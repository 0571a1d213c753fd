package frustum.charts.systems

import frustum.boards.BoardTop
import frustum.boards.icebreaker.IcebreakerTops
import frustum.contract.InputError
import frustum.contract.raster.{PlaneFormats, RasterConfig}
import frustum.driver.raster.PreparedFrame
import frustum.driver.scene.Scene
import java.nio.file.Path
import scala.collection.mutable
import scala.concurrent.duration.Duration
import scala.concurrent.{Await, ExecutionContext, Future}

/** Renderers of triangles on the iCEBreaker: frames a second against errors, a chart for each scene.
  *
  * @param tops         what place and route made of a top, and the digest of its Verilog, see [[PlacedTops]]
  * @param simulatesAll also hardware made for one scene is simulated where its cycles are not known; otherwise only
  *                     hardware that all scenes share is
  * @param compile      makes a simulation ready ahead of its use
  * @param fits         reports of `fit`
  */
final class RasterSystems(
    tops: BoardTop => (Option[Placed], String),
    cycles: SystemCycles,
    simulatesAll: Boolean,
    compile: RasterConfig => Unit,
    peer: Option[PeerFigures],
    say: String => Unit,
    fits: Path = FittedDesign.Reports
) {
  private val base = RasterConfig()
  private val known = mutable.Map.empty[RasterConfig, (Option[Placed], String)]

  /** A system with its hardware's figures and the frame that it is sent.
    *
    * @param frame   for [[RasterSystems.timed]]
    * @param verilog digest of that hardware
    */
  private case class Candidate(
      system: SystemConfiguration,
      placed: Option[Placed],
      verilog: String,
      frame: PreparedFrame
  ) {
    val simulated: Boolean = simulatesAll || !Set(SystemConfiguration.Scene, SystemConfiguration.Fitted)(system.group)
    def cycles(simulate: Boolean): Option[Long] = RasterSystems.this.cycles(frame, verilog, simulate && simulated)
  }

  /** @param scenes by the names of their charts */
  def charts(scenes: Seq[Scene], each: SystemChart => Unit): Unit = {
    val judges = scenes.map(s => new SystemErrors(s, base.width, base.height))
    val candidates = scenes.zip(judges).map { case (scene, judge) =>
      say(s"${scene.name}: hardware of its configurations")
      SystemConfiguration.all(scene, base).map(c => candidate(c, judge, None)) ++ fitted(scene, judge)
    }
    val missing = candidates.flatten.filter(c => c.simulated && c.cycles(simulate = false).isEmpty)
    val ready = Future.traverse(missing.map(_.frame.config).distinct)(c => Future(compile(c))(pool))(implicitly, pool)
    val errors = candidates.zip(judges).map { case (all, judge) => all.map(c => c -> judge(c.system)) }
    Await.result(ready, Duration.Inf)
    for ((scene, all) <- scenes.zip(errors)) {
      say(s"${scene.name}: cycles of ${all.length} frames")
      each(chart(scene, all))
    }
  }

  private def pool = ExecutionContext.global

  private def candidate(c: SystemConfiguration, judge: SystemErrors, told: Option[Placed]): Candidate = {
    def figures(config: RasterConfig) = known.getOrElseUpdate(config, tops(IcebreakerTops.rasterOf("system", config)))
    val placed = told.orElse(figures(c.config)._1).filter(_ => c.built)
    val timed = RasterSystems.timed(c.config)
    Candidate(c, placed, figures(timed)._2, judge.frame(c).copy(config = timed))
  }

  /** What `fit` answered, unless its hardware does not take the scene as it is drawn here. */
  private def fitted(scene: Scene, judge: SystemErrors): Seq[Candidate] =
    FittedDesign.read(scene.name, base, SystemConfiguration.plain(scene), fits).toSeq.flatMap { f =>
      try Seq(candidate(f.configuration, judge, f.placed))
      catch {
        case InputError(why) =>
          say(s"${scene.name}: the design of $fits is left out: $why")
          Nil
      }
    }

  private def chart(scene: Scene, all: Seq[(Candidate, SystemError)]): SystemChart = {
    val points = for ((c, e) <- all; n <- c.cycles(simulate = true)) yield {
      val mhz = c.placed.flatMap(_.clockMHz)
      val clock = mhz.getOrElse(IcebreakerTops.raster.targetMHz.toDouble)
      SystemPoint(
        c.system.group,
        c.system.setting + (if (c.placed.isDefined && mhz.isEmpty) " (does not fit)" else ""),
        clock * 1e6 / n,
        clock,
        mhz.isDefined,
        c.system.built,
        c.placed.flatMap(_.cells),
        Seq(Some(e.flip), Some(e.wrongPercent)),
        Seq("cyclesPerFrame" -> n.toDouble)
      )
    }
    val left = all.length - points.length
    SystemChart(
      s"systems-${scene.name}",
      s"${scene.name}: frames a second against error, iCE40UP5K, ${base.width} x ${base.height}",
      "frames a second: placed clock over simulated cycles a frame",
      Seq("mean FLIP, end to end (0 equal, 1 worst)", "wrong triangle or texel, % of pixels"),
      points,
      peer.flatMap(peerOf(scene.name, _)).toSeq,
      "The library has one preset and nearest texels alone: no other preset, no bilinear filter is among the points." +
        (if (left == 0) "" else s" Systems left out, as their cycles are not known: $left; --synthesis finds them."),
      errorFloor = 1e-4,
      cellsTitle = Some(s"${scene.name}: logic cells against error, iCE40UP5K, ${base.width} x ${base.height}")
    )
  }

  /** What the compared system measured of a scene. */
  private def peerOf(scene: String, p: PeerFigures): Option[PeerPoint] = {
    def point(cycles: Option[(Double, Double)], wrong: Option[(Double, Double)]) =
      Some(PeerPoint(p.name, cycles.map(p.framesPerSecond), Some(p.logicCells), Seq(None, wrong)))
    scene match {
      case "cube"  => point(Some(p.cubeCycles), None)
      case "floor" => point(None, Some(p.floorTexelsWrong))
      case "quad"  => point(Some(p.quadCycles(base.width * base.height)), Some(p.quadTexelsWrong))
      case _       => None
    }
  }
}

object RasterSystems {

  /** Hardware that takes as many cycles for every frame, so that it is simulated in place of several: bits that the
    * planes go without narrow adders and registers, and nothing waits for what they hold.
    */
  def timed(config: RasterConfig): RasterConfig = config.copy(formats = PlaneFormats())
}
