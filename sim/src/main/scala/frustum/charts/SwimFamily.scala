package frustum.charts

import frustum.judge.TemporalJudge
import frustum.scene.Scenes
import frustum.synthesis.UnitCosts

/** Swimming against sub-pixel bits. */
object SwimFamily extends ChartFamily {
  val name = "swim"

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val points = for (scene <- Seq("cube", "terrain"); bits <- 0 to 4)
      yield ChartPoint(
        scene,
        s"$bits bits",
        bits,
        TemporalJudge.pan(Scenes.byName(scene), TemporalJudge.Config, bits).swimRms
      )
    Seq(Chart(
      "swim",
      "Swimming of texels against sub-pixel bits, scenes moved by 1/16 pixel",
      "sub-pixel bits",
      "change of the texel error from step to step, root mean square, texels",
      points,
      points.find(p => p.method == "cube" && p.cost == 4),
      points.find(p => p.method == "cube" && p.cost == 2),
      1e-4,
      "Each bit takes a third to a half of it. The peers' vertices have 2 bits.",
      scenes = true
    ))
  }
}
