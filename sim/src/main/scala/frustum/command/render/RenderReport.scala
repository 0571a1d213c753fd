package frustum.command.render

import frustum.boards.Tops
import frustum.BuildInfo
import frustum.command.common.Clock
import frustum.files.{InfinityAsNull, Notices}
import frustum.referee.EndToEnd
import java.nio.file.{Files, Path, Paths}
import scala.util.Try

/** The JSON report of `render` and of each scene of `demo`. What the engine does not produce is absent. */
object RenderReport {
  private val Top = "icebreaker-raster"

  def json(command: String, seed: Long, f: SceneFigures, clock: Clock = Clock.ofTop(Top)): ujson.Obj = {
    val report = ujson.Obj(
      "command" -> command,
      "version" -> BuildInfo.version,
      "seed" -> seed.toDouble,
      "engine" -> f.engine,
      "scene" -> f.scene,
      "width" -> f.config.width,
      "height" -> f.config.height,
      "frames" -> f.frames.length,
      "notices" -> Notices.json(f.notices)
    )
    def put(key: String, value: Option[Double]): Unit = value.foreach(v => report(key) = v)
    val clocks = f.mean(_.clocks)
    val atPins = f.mean(_.clocksAtPins)
    val fragments = f.mean(frame => Some(frame.fragments))
    put("triangles", f.mean(frame => Some(frame.sceneTriangles.toLong)))
    put("trianglesDrawn", f.mean(frame => Some(frame.trianglesDrawn.toLong)))
    put("trianglesFacingAway", f.mean(frame => Some(frame.leftOut.facingAway.toLong)))
    put("trianglesWithoutArea", f.mean(frame => Some(frame.leftOut.withoutArea.toLong)))
    put("trianglesUndrawn", f.mean(_.undrawn))
    put("fragments", fragments)
    put("clocksPerFrame", clocks)
    put("clocksPerFrameAtPins", atPins)
    put("clocksPerFragment", clocks.zip(fragments.filter(_ > 0)).map { case (c, n) => c / n })
    put("busBytes", f.mean(_.busBytes))
    put("setUps", f.mean(_.setUps))
    put("moves", f.mean(_.moves))
    put("passes", f.mean(frame => Some(frame.passes.toLong)))
    if (clocks.isDefined || atPins.isDefined) {
      report("clockMHz") = clock.mhz
      report("clockSource") = clock.source
      put("framesPerSecond", clocks.map(clock.mhz * 1e6 / _))
      put("framesPerSecondAtPins", atPins.map(clock.mhz * 1e6 / _))
    }
    report("engineSeconds") = f.seconds
    f.pixelsDifferent.foreach(n => report("hardwareVsModel") = ujson.Obj("pixelsDifferent" -> n.toDouble))
    f.model.foreach { m =>
      report("modelVsReference") = ujson.Obj(
        "coverageWrong" -> m.coverage.wrong.toDouble,
        "coverageMissing" -> m.coverage.missing.toDouble,
        "coverageExtra" -> m.coverage.extra.toDouble,
        "coverageTwice" -> m.coverage.twice.toDouble,
        "texelsJudged" -> m.texels.judged.toDouble,
        "texelsWrong" -> m.texels.wrong.toDouble,
        "texelsWrongByMoreThanOne" -> m.texels.wrongByMoreThanOne.toDouble,
        "maxTexelError" -> m.texels.maxError,
        "primitiveWrong" -> m.depth.primitiveWrong.toDouble,
        "depthOrderWrong" -> m.depth.depthOrderWrong.toDouble,
        "psnr" -> InfinityAsNull.write(f.psnr)
      )
    }
    val (snappingPsnr, snappingFlip) = f.overall(_.snappingDistance)
    report("snapping") = ujson.Obj(
      "coverageWrong" -> f.snapping.coverageWrong.toDouble,
      "texelsWrong" -> f.snapping.texelsWrong.toDouble,
      "psnr" -> InfinityAsNull.write(snappingPsnr),
      "flip" -> snappingFlip
    )
    f.endToEnd.foreach { e =>
      val own = endToEnd(e.counts, e.distance)
      if (e.counts.referee != e.world.referee) own("world") = endToEnd(e.world, e.worldDistance)
      report("endToEnd") = own
    }
    report
  }

  private def endToEnd(c: EndToEnd, distance: (Option[Double], Double)): ujson.Obj = {
    val counts = ujson.Obj(
      "referee" -> c.referee,
      "judged" -> c.judged.toDouble,
      "primitiveWrong" -> c.primitiveWrong.toDouble,
      "texelsWrong" -> c.texelsWrong.toDouble,
      "primitiveUnexplained" -> c.primitiveUnexplained.toDouble,
      "texelsUnexplained" -> c.texelsUnexplained.toDouble,
      "colorWrong" -> c.colorWrong.toDouble,
      "psnr" -> InfinityAsNull.write(distance._1),
      "flip" -> distance._2
    )
    if (c.referee != EndToEnd.World) counts("refereesDiffer") = c.refereesDiffer.toDouble
    counts
  }
}
