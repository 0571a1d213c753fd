package frustum.charts.systems

/** A whole system.
  *
  * @param group    what it differs in from the shipped one, @param setting by how much
  * @param speed    in the unit of the chart's axis
  * @param clockMHz that the speed is reckoned with
  * @param placed   whether place and route gave that clock; else it is what the top aims at
  * @param built    whether the library has such hardware; else the error is a method's alone
  * @param cells    logic cells, where place and route has told
  * @param errors   by the chart's error axes; None where a system has no such error
  * @param facts    what else is known, by name
  */
final case class SystemPoint(
    group: String,
    setting: String,
    speed: Double,
    clockMHz: Double,
    placed: Boolean,
    built: Boolean,
    cells: Option[Int],
    errors: Seq[Option[Double]],
    facts: Seq[(String, Double)] = Nil
)

/** What others measured of a compared system, along the axes of a chart.
  *
  * @param errors by the chart's error axes
  */
final case class PeerPoint(
    name: String,
    speed: Option[(Double, Double)],
    cells: Option[(Double, Double)],
    errors: Seq[Option[(Double, Double)]]
)
