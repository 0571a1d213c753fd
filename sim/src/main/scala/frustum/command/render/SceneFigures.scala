package frustum.command.render

import frustum.contract.raster.RasterConfig
import frustum.driver.raster.PreparedFrame
import frustum.engine.raster.RenderedFrame
import frustum.driver.scene.Notice
import frustum.judge.{EndToEndVerdict, Flip, FrameVerdict, ModelVerdict, Psnr}
import java.nio.file.Path

/** The figures of one frame, its pictures left behind. */
final case class FrameFigures(
    sceneTriangles: Int,
    trianglesDrawn: Int,
    passes: Int,
    fragments: Long,
    clocks: Option[Long],
    clocksAtPins: Option[Long],
    busBytes: Option[Long],
    setUps: Option[Long],
    moves: Option[Long],
    pixelsDifferent: Option[Long],
    model: Option[ModelVerdict],
    squaredError: Double,
    endToEnd: EndToEndVerdict,
    endToEndSquaredError: Double,
    flip: Double
)

object FrameFigures {
  def apply(frame: PreparedFrame, drawn: RenderedFrame, v: FrameVerdict): FrameFigures = FrameFigures(
    frame.sceneTriangles,
    frame.trianglesDrawn,
    frame.passes.length,
    v.fragments,
    drawn.clocks,
    drawn.clocksAtPins,
    drawn.busBytes,
    drawn.setUps,
    drawn.moves,
    v.pixelsDifferent,
    v.model,
    Psnr.squaredError(v.picture, v.reference),
    v.endToEnd,
    Psnr.squaredError(v.picture, v.endToEndPicture),
    new Flip(frame.config.width, frame.config.height).mean(v.endToEndPicture, v.picture)
  )
}

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
  def endToEnd: EndToEndVerdict = frames.map(_.endToEnd).reduce(_ + _)
  def psnr: Option[Double] = Psnr.of(frames.map(_.squaredError).sum, pixels)
  def endToEndPsnr: Option[Double] = Psnr.of(frames.map(_.endToEndSquaredError).sum, pixels)
  def flip: Double = frames.map(_.flip).sum / frames.length

  /** What must be zero and is not. */
  def failures: Seq[String] =
    pixelsDifferent.filter(_ > 0).map(n => s"$n pixels differ from the model's").toSeq ++
      model.map(_.coverage).filter(_.wrong > 0).map(c =>
        s"coverage is wrong: ${c.missing} pixels missing, ${c.extra} extra, ${c.twice} twice"
      )

  /** Exit code; a failure is told on stderr with the report that has the figures. */
  def verdict(report: Path): Int = {
    failures.foreach(f => Console.err.println(s"error: $scene: $f; see $report"))
    if (failures.isEmpty) 0 else 1
  }
}
