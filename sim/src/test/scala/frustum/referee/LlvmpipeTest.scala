package frustum.referee

import frustum.command.budgets.AnyPictures
import frustum.command.render.EndToEndBounds
import frustum.contract.raster.{RasterConfig, Wrap}
import frustum.driver.raster.DrawOptions
import frustum.judge.Psnr
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite

/** Two referees of different descent, float64 and Mesa, show the same. Skipped where libosmesa6-dev or gcc is missing.
  */
class LlvmpipeTest extends AnyFunSuite {
  private def compare(name: String, view: WorldView): Unit = {
    val mesa = Llvmpipe.draw(view).getOrElse(cancel("Mesa is not here: install libosmesa6-dev and gcc"))
    val world = new WorldPicture(view)
    val judged = world.judged.indices.filter(world.judged(_))
    val shapes = judged.count(at => !mesa.seen.samePrimitives(world.seen, at))
    val texels = judged.filter(world.texelsJudged(_))
      .count(at => mesa.seen.samePrimitives(world.seen, at) && !mesa.seen.sameTexels(world.seen, at))
    val percent = 100.0 * (shapes + texels) / judged.length
    val psnr = Psnr.of(world.picture, mesa.picture)
    info(f"$name: $shapes primitives and $texels texels of ${judged.length} differ, $percent%.3f %%; PSNR ${psnr.fold(
        "equal"
      )(p => f"$p%.1f dB")}")
    assert(percent <= EndToEndBounds.MostDiffer && psnr.forall(_ > 25), name)
  }

  test("the scenes of the demo") {
    for (name <- Scenes.names) {
      val scene = Scenes.byName(name)
      compare(
        name,
        Request(scene, DrawOptions(None, cullBack = false, Wrap.Repeat, scene.background), RasterConfig()).view
      )
    }
  }

  test("other cameras, lights, wrap modes and projections") {
    for ((run, i) <- AnyPictures.all.zipWithIndex)
      compare(
        s"picture $i, ${run.scene.name}",
        Request(run.scene.copy(camera = run.camera), run.options.copy(turnDegrees = run.turnDegrees), run.config).view
      )
  }
}
