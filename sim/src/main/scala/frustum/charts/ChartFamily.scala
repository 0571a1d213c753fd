package frustum.charts

import frustum.synthesis.UnitCosts

/** Methods for one task, to be charted. */
trait ChartFamily {
  def name: String

  /** @param costs what synthesis makes of a unit, None where that is not wanted */
  def charts(costs: Option[UnitCosts]): Seq[Chart]
}

object ChartFamily {
  val all: Seq[ChartFamily] =
    Seq(
      ReciprocalFamily,
      AreaFamily,
      RootFamily,
      SpanFamily,
      AccumulationFamily,
      TileFamily,
      AttributeFamily,
      DepthFamily,
      SubpixelFamily,
      SwimFamily,
      FilterFamily,
      ColorFamily,
      SphereFamily,
      LeapFamily,
      DirectionFamily
    )
}
