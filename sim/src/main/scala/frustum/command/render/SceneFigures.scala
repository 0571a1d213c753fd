package frustum.command.render

import frustum.contract.raster.RasterConfig
import frustum.driver.raster.{LeftOut, PreparedFrame}
import frustum.engine.raster.RenderedFrame
import frustum.driver.scene.Notice
import frustum.judge.{EndToEndVerdict, Flip, FrameVerdict, ModelVerdict, Psnr, SnappingVerdict}
import frustum.referee.EndToEnd
import java.nio.file.Path

/** How far a picture is from another.
  *
  * @param flip mean FLIP
  */
final case class Distance(squaredError: Double, flip: Double)

object Distance {
  def apply(frame: PreparedFrame, picture: Array[Int], from: Array[Int]): Distance =
    Distance(Psnr.squaredError(picture, from), new Flip(frame.config.width, frame.config.height).mean(from, picture))
}

/** The referee's figures of a frame: `counts` and `distance` of the one that the report names, and those of float64,
  * which are bounded.
  */
final case class EndToEndFigures(counts: EndToEnd, distance: Distance, world: EndToEnd, worldDistance: Distance)

object EndToEndFigures {
  def apply(frame: PreparedFrame, picture: Array[Int], v: EndToEndVerdict): EndToEndFigures = {
    val world = Distance(frame, picture, v.worldPicture)
    val own = if (v.picture eq v.worldPicture) world else Distance(frame, picture, v.picture)
    EndToEndFigures(v.counts, own, v.world, world)
  }
}

/** The figures of one frame, its pictures left behind. */
final case class FrameFigures(
    sceneTriangles: Int,
    trianglesDrawn: Int,
    leftOut: LeftOut,
    passes: Int,
    fragments: Long,
    clocks: Option[Long],
    clocksAtPins: Option[Long],
    busBytes: Option[Long],
    setUps: Option[Long],
    moves: Option[Long],
    undrawn: Option[Long],
    pixelsDifferent: Option[Long],
    model: Option[ModelVerdict],
    squaredError: Double,
    snapping: SnappingVerdict,
    snappingDistance: Distance,
    endToEnd: Option[EndToEndFigures]
)

object FrameFigures {
  def apply(frame: PreparedFrame, drawn: RenderedFrame, v: FrameVerdict): FrameFigures = FrameFigures(
    frame.sceneTriangles,
    frame.trianglesDrawn,
    frame.leftOut,
    frame.passes.length,
    v.fragments,
    drawn.clocks,
    drawn.clocksAtPins,
    drawn.busBytes,
    drawn.setUps,
    drawn.moves,
    drawn.undrawn,
    v.pixelsDifferent,
    v.model,
    Psnr.squaredError(v.picture, v.reference),
    v.snapping,
    Distance(frame, v.picture, v.snappingPicture),
    v.endToEnd.map(EndToEndFigures(frame, v.picture, _))
  )
}

/** As [[EndToEndFigures]], of all frames: decibels, None where the pictures are equal, and mean FLIP. */
final case class EndToEndSum(
    counts: EndToEnd,
    distance: (Option[Double], Double),
    world: EndToEnd,
    worldDistance: (Option[Double], Double)
)

/** The figures of all frames of a scene: sizes and times are means over frames, faults are sums, the greatest
  * texel error is the greatest of all.
  *
  * @param seconds wall time of the engine
  * @param notices what of the scene was skipped, replaced or not drawn
  */
final case class SceneFigures(
    scene: String,
    engine: String,
    config: RasterConfig,
    frames: Seq[FrameFigures],
    seconds: Double,
    notices: Seq[Notice] = Nil
) {
  private val pixels = config.width.toLong * config.height * frames.length

  /** Mean over frames, None where a frame has none. */
  def mean(of: FrameFigures => Option[Long]): Option[Double] = {
    val values = frames.flatMap(of(_))
    Option.when(values.length == frames.length)(values.sum.toDouble / frames.length)
  }
  def pixelsDifferent: Option[Long] =
    frames.map(_.pixelsDifferent).reduce((a, b) => a.zip(b).map { case (x, y) => x + y })
  def model: Option[ModelVerdict] =
    frames.map(_.model).reduce((a, b) => a.zip(b).map { case (x, y) => x + y })
  def snapping: SnappingVerdict = frames.map(_.snapping).reduce(_ + _)
  def psnr: Option[Double] = Psnr.of(frames.map(_.squaredError).sum, pixels)

  /** Decibels and FLIP of distances, one of each frame. */
  def overall(of: FrameFigures => Distance): (Option[Double], Double) =
    (Psnr.of(frames.map(of(_).squaredError).sum, pixels), frames.map(of(_).flip).sum / frames.length)

  /** Of the referee, where the frames' input is known to it. */
  def endToEnd: Option[EndToEndSum] =
    Option.when(frames.forall(_.endToEnd.isDefined))(EndToEndSum(
      frames.map(_.endToEnd.get.counts).reduce(_ + _),
      overall(_.endToEnd.get.distance),
      frames.map(_.endToEnd.get.world).reduce(_ + _),
      overall(_.endToEnd.get.worldDistance)
    ))

  /** What must be zero and is not. */
  def failures: Seq[String] =
    pixelsDifferent.filter(_ > 0).map(n => s"$n pixels differ from the model's").toSeq ++
      model.map(_.coverage).filter(_.wrong > 0).map(c =>
        s"coverage is wrong: ${c.missing} pixels missing, ${c.extra} extra, ${c.twice} twice"
      )

  /** Exit code; a failure is told on stderr with the report that has the figures.
    *
    * @param beyond what else is wrong
    */
  def verdict(report: Path, beyond: Seq[String] = Nil): Int = {
    val failures = this.failures ++ beyond
    failures.foreach(f => Console.err.println(s"error: $scene: $f; see $report"))
    if (failures.isEmpty) 0 else 1
  }
}
