package frustum.charts

import frustum.contract.raster.{PlaneFormats, RasterConfig, Wrap}
import frustum.driver.raster.{DrawOptions, Driver, PreparedFrame}
import frustum.engine.raster.{EngineOptions, RasterEngines}
import frustum.judge.FrameJudge
import frustum.scene.Scenes
import frustum.synthesis.UnitCosts

/** Sizes of tiles: a large one has fewer triangles moved to it, and gradients that add up over more pixels. Clocks are
  * the simulated core's.
  */
object TileFamily extends ChartFamily {
  val name = "tiles"

  private val Dropped = 6 // bits that the planes go without, so that the errors show
  private val sizes = Seq((4, 4), (5, 4), (5, 5)) // a screen has at most 32 tiles a side
  private val judge = new FrameJudge(RasterEngines.model, simulated = false)

  private def frame(scene: String, config: RasterConfig): PreparedFrame = {
    val s = Scenes.byName(scene)
    Driver.prepare(s, s.camera, DrawOptions(None, cullBack = false, Wrap.Repeat, s.background), config, 0)
  }
  private def config(log2Width: Int, log2Height: Int) = RasterConfig(
    tileLog2Width = log2Width,
    tileLog2Height = log2Height,
    formats = PlaneFormats(coordinate = Dropped)
  )

  def wrongPercent(scene: String, log2Width: Int, log2Height: Int): Double = {
    val texels = judge.drawModel(frame(scene, config(log2Width, log2Height)))._1.texels
    100.0 * texels.wrong / texels.judged
  }

  private def clocksPerPixel(scene: String, log2Width: Int, log2Height: Int): Double = {
    val c = config(log2Width, log2Height)
    val prepared = frame(scene, c)
    val drawn = RasterEngines.byName("pipeline").make(EngineOptions(1, None)).drawAll(Seq(prepared)).head
    drawn.clocks.get.toDouble / (c.width * c.height)
  }

  def charts(costs: Option[UnitCosts]): Seq[Chart] = costs.toSeq.map { _ =>
    val points = for {
      scene <- Seq("cube", "floor")
      (w, h) <- sizes
    } yield ChartPoint(
      scene,
      s"${1 << w} x ${1 << h}",
      clocksPerPixel(scene, w, h),
      wrongPercent(scene, w, h)
    )
    Chart(
      "tiles",
      s"Tiles from 16 x 16 to 32 x 32, planes of s/w, t/w and 1/w with ${32 - Dropped} bits",
      "clocks a pixel of the screen, simulated",
      "wrong texels, %",
      points,
      points.find(p => p.method == "cube" && p.setting == "16 x 16"),
      None,
      1e-3,
      "Larger tiles take fewer clocks and more block RAM, and make more texels wrong: gradients add up over more " +
        "pixels.",
      scenes = true
    )
  }
}
