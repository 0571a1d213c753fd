package frustum.boards.flow

import frustum.boards.BoardTop

/** The results of placing a top with several seeds. Figures are the worst of the seeds.
  *
  * @param engine     the programs and their versions
  * @param icetimeMHz one figure per seed; empty when there is no icetime
  */
final case class BitstreamReport(
    top: BoardTop,
    engine: String,
    placements: Seq[Placement],
    icetimeMHz: Seq[Double]
) {
  def fits: Boolean = placements.forall(_.fits)

  /** The core clock's MHz, seed by seed. */
  val coreMHz: Seq[Double] = placements.filter(_.fits).map { p =>
    val byNet = p.clocks.map { case (net, figures) => BitstreamReport.plainNet(net) -> figures }
    for ((net, (_, required)) <- byNet) {
      val wanted = top.clocks.find(_.net == net).map(_.mhz.toDouble)
      if (!wanted.exists(mhz => (mhz - required).abs < mhz / 1000))
        throw FlowFault(
          s"nextpnr held the clock $net to $required MHz, the table of tops to ${wanted.getOrElse("nothing")}"
        )
    }
    val core = byNet.get(top.core.net)
    core.getOrElse(throw FlowFault(s"nextpnr found no clock ${top.core.net}, only ${byNet.keys.mkString(", ")}"))._1
  }

  /** Clocks that fall short in some seed, with what they reach. */
  def shortfalls: Seq[String] = for {
    p <- placements
    (net, (achieved, required)) <- p.clocks.toSeq.sorted
    if achieved < required
  } yield f"seed ${p.seed}: $net $achieved%.2f of $required%.2f MHz"

  def meetsTarget: Boolean =
    fits && shortfalls.isEmpty && coreMHz.min >= top.targetMHz.toDouble && icetimeMHz.forall(
      _ >= top.targetMHz.toDouble
    )

  /** The seed whose bitstream is kept: the one with the greatest margin. */
  def bestSeed: Int =
    if (icetimeMHz.isEmpty) placements.zip(coreMHz).maxBy(_._2)._1.seed
    else placements.zip(coreMHz.zip(icetimeMHz).map { case (a, b) => a min b }).maxBy(_._2)._1.seed

  private def worst(kind: String): Int = placements.flatMap(_.used.get(kind)).maxOption.getOrElse(0)

  def json(version: String): ujson.Obj = {
    val figures = ujson.Obj(
      "command" -> "bitstream",
      "version" -> version,
      "seed" -> placements.head.seed,
      "engine" -> engine,
      "top" -> top.name,
      "part" -> top.part.name,
      "fits" -> fits
    )
    for ((key, kinds) <- top.part.figures) figures(key) = kinds.map(worst).sum
    if (fits)
      figures("clockMHz") = ujson.Obj("min" -> coreMHz.min, "max" -> coreMHz.max, "seeds" -> ujson.Arr.from(coreMHz))
    if (fits && icetimeMHz.nonEmpty) figures("icetimeMHz") = icetimeMHz.min
    figures("targetMHz") = top.targetMHz.toDouble
    figures("meetsTarget") = meetsTarget
    figures
  }
}

object BitstreamReport {

  /** A net's name without what yosys and nextpnr put before it, as in `$abc$1$iopadmap$clk` and
    * `$glbnet$clk$TRELLIS_IO_IN`, or append on the way from a pad to a global buffer; yosys joins the names of a
    * hierarchy by an underscore or, since 0.70, by a dot.
    */
  def plainNet(net: String): String = {
    val parts = net.stripSuffix("$TRELLIS_IO_IN").split('$')
    (if (net.startsWith("$")) parts.last else parts.head).replace('.', '_')
  }
}
