package frustum.command.report

import frustum.command.common.{Figure, Page}

/** What synthesis, place and route make of each top. */
object BitstreamsPart extends ReportPart("Bitstreams", "bitstream", "bitstream icebreaker-raster --seeds 3") {
  def shown(files: ReportFiles): Option[Shown] = {
    val tops = files.ofKind(".json").map(f => files.read(f)(r => (cells(r), r("meetsTarget").bool)))
    Option.when(tops.nonEmpty)(
      Shown(
        s"<section>${Page.table(Head, tops.map(_._1), n => !tops(n)._2)}</section>",
        s"${tops.count(_._2)} of ${tops.length} fit and reach their clock",
        tops.forall(_._2),
        files.ofKind(".json")
      )
    )
  }

  private val Head = Seq(
    "top",
    "part",
    "logic cells or LUTs",
    "block RAMs",
    "DSP blocks",
    "MHz, slowest of the seeds",
    "seeds",
    "MHz in icetime",
    "target MHz",
    "verdict"
  )

  private def cells(r: ujson.Obj): Seq[String] = {
    def first(keys: String*) = keys.flatMap(r.value.get).headOption.fold("")(v => Figure(v.num))
    val clock = r.value.get("clockMHz")
    val verdict = (r("fits").bool, r("meetsTarget").bool) match {
      case (false, _)   => "<b class=\"bad\">does not fit</b>"
      case (_, false)   => "<b class=\"bad\">too slow</b>"
      case (true, true) => "<span class=\"good\">met</span>"
    }
    Seq(
      Page.escape(r("top").str),
      Page.escape(r("part").str),
      first("logicCells", "luts"),
      first("ebr", "bram36"),
      first("dsp", "dsp48"),
      clock.fold("")(c => Figure(c("min").num)),
      clock.fold("")(c => c("seeds").arr.length.toString),
      first("icetimeMHz"),
      first("targetMHz"),
      verdict
    )
  }
}
