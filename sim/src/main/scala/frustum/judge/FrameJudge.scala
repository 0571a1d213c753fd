package frustum.judge

import frustum.contract.raster.RasterConfig
import frustum.driver.raster.PreparedFrame
import frustum.engine.raster.{ReferenceRenderer, RenderedFrame}
import frustum.model.raster.PassRenderer
import frustum.picture.Picture
import frustum.referee.WorldView
import frustum.reference.raster.{ReferenceFrame, ReferenceRaster}

/** The model against the reference that was fed with the vertices as the hardware decodes them. */
final case class ModelVerdict(coverage: CoverageVerdict, texels: AttributeVerdict, depth: DepthVerdict) {
  def +(o: ModelVerdict): ModelVerdict =
    ModelVerdict(coverage + o.coverage, texels + o.texels, depth + o.depth)
}

/** Everything known of one rendered frame. Pictures are 0xRRGGBB.
  *
  * @param fragments       covered pixels entering the fragment stages
  * @param pixelsDifferent from the model's picture, for a simulated engine
  * @param model           for every engine but the reference
  * @param snapping        and its picture: what the rounding of vertices costs
  * @param endToEnd        where it is known what the frame was made from
  */
final case class FrameVerdict(
    picture: Array[Int],
    reference: Array[Int],
    snappingPicture: Array[Int],
    fragments: Long,
    pixelsDifferent: Option[Long],
    model: Option[ModelVerdict],
    snapping: SnappingVerdict,
    endToEnd: Option[EndToEndVerdict]
)

/** Judges the frames of an engine.
  *
  * @param model the model that the engine is held against; None for the reference itself
  */
final class FrameJudge(model: Option[RasterConfig => PassRenderer], simulated: Boolean) {

  /** @param view what the frame was made from; None: the driver's part is not judged */
  def judge(frame: PreparedFrame, rendered: RenderedFrame, view: Option[WorldView] = None): FrameVerdict = {
    val config = frame.config
    val memory = ReferenceRaster.texelMemory(frame.textures)
    val image = new Array[Int](config.width * config.height)
    val logs = draw(frame, memory, image)
    val reference = ReferenceRaster.draw(frame).rgb888
    val (snapping, snappingPicture) = SnappingJudge.judge(frame, logs)
    // The reference's own picture need not be squeezed into RGB565.
    val picture = if (model.isEmpty) reference else Picture.ofRgb565(rendered.image)
    FrameVerdict(
      picture,
      reference,
      snappingPicture,
      logs.map(_.length.toLong).sum,
      Option.when(simulated)(image.indices.count(i => image(i) != rendered.image(i)).toLong),
      Option.when(model.isDefined)(judgeModel(frame, logs, memory)),
      snapping,
      view.map(EndToEndJudge.judge(_, frame, logs, picture))
    )
  }

  /** A frame as its model draws it, without an engine's picture. */
  def drawModel(frame: PreparedFrame): (ModelVerdict, Array[Int], Seq[IndexedSeq[LoggedFragment]]) = {
    val memory = ReferenceRaster.texelMemory(frame.textures)
    val image = new Array[Int](frame.config.width * frame.config.height)
    val logs = draw(frame, memory, image)
    (judgeModel(frame, logs, memory), Picture.ofRgb565(image), logs)
  }

  private def draw(frame: PreparedFrame, memory: Array[Int], image: Array[Int]): Seq[IndexedSeq[LoggedFragment]] = {
    val renderer = model.fold[PassRenderer](new ReferenceRenderer(frame.config))(_(frame.config))
    frame.passes.map { pass =>
      val log = new FragmentLog
      renderer.draw(pass, memory, image, Some(log))
      log.fragments
    }
  }

  private def judgeModel(
      frame: PreparedFrame,
      logs: Seq[IndexedSeq[LoggedFragment]],
      memory: Array[Int]
  ): ModelVerdict =
    frame.passes.zip(logs).map { case (pass, log) =>
      val reference = new ReferenceFrame(frame.config)
      ReferenceRaster.drawPass(reference, pass, memory, 0, _ => ())
      ModelVerdict(
        CoverageJudge.judge(pass, log, frame.config),
        AttributeJudge.judge(pass, log),
        new DepthJudge(pass, frame.config, memory).judge(log, reference)
      )
    }.reduceOption(_ + _).getOrElse(ModelVerdict(
      CoverageJudge.Clean,
      AttributeJudge.Clean,
      DepthVerdict(0, 0)
    ))
}
