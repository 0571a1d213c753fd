package frustum.charts

import frustum.contract.raster.{PlaneFormats, RasterConfig, Wrap}
import frustum.driver.raster.{DrawOptions, Driver}
import frustum.engine.raster.RasterEngines
import frustum.judge.FrameJudge
import frustum.raster.scan.Interpolator
import frustum.scene.Scenes
import frustum.synthesis.UnitCosts

/** Lowest bits that the planes of s/w, t/w and 1/w go without: wrong texels of scenes by the bit-exact model. */
object AttributeFamily extends ChartFamily {
  val name = "attributes"

  private val dropped = 0 to 12 by 2
  private val scenes = Seq("cube", "floor", "terrain")
  private val judge = new FrameJudge(RasterEngines.model, simulated = false)

  /** Wrong texels of 100 judged ones, from the scene's own camera. */
  def wrongPercent(scene: String, bits: Int): Double = {
    val s = Scenes.byName(scene)
    val config = RasterConfig(formats = PlaneFormats(coordinate = bits))
    val options = DrawOptions(None, cullBack = false, Wrap.Repeat, s.background)
    val texels = judge.drawModel(Driver.prepare(s, s.camera, options, config, 0))._1.texels
    100.0 * texels.wrong / texels.judged
  }

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    def unit(n: Int) = costs.map(_.timed(s"interpolator without $n bits")(Interpolator(
      RasterConfig(formats = PlaneFormats(coordinate = n))
    )))
    val units = dropped.map(n => n -> unit(n))
    val points = for (scene <- scenes; (n, unit) <- units)
      yield ChartPoint(scene, s"${32 - n} bits", unit.fold(32.0 - n)(_.cells), wrongPercent(scene, n), unit)
    Seq(Chart(
      "attribute-bits",
      "Bits of the planes of s/w, t/w and 1/w",
      if (costs.isDefined) "LUT and flip-flops of the interpolator, iCE40" else "bits",
      "wrong texels, %",
      points,
      points.find(p => p.method == "floor" && p.setting == "32 bits"),
      None,
      1e-3,
      "Each bit less makes two to three times as many wrong: values are cut, and a tile's steps add up what was cut. " +
        "The perspective divide shrinks as well, which this cost leaves out.",
      scenes = true
    ))
  }
}
