package frustum.command.report

import frustum.command.common.{Figure, Page}
import frustum.command.mutate.MutateCommand

/** What `mutate` found of the units' test vectors. */
object MutatePart extends ReportPart("Mutation testing", "mutate", "mutate") {
  def shown(files: ReportFiles): Option[Shown] = files.find("mutate.json").map(file =>
    files.read(file) { report =>
      val units = report("units").arr.toSeq
      val weak = units.count(_("killPercent").num < MutateCommand.Least)
      val rows = units.map(u =>
        Page.escape(u("unit").str) +: Seq(u("mutants"), u("killed"), u("equivalent"), u("killPercent")).map(v =>
          Figure(v.num)
        )
      )
      Shown(
        s"<section>${Page.table(Head, rows, n => units(n)("killPercent").num < MutateCommand.Least)}</section>",
        if (weak == 0)
          s"the vectors of all ${units.length} units find ${Figure(MutateCommand.Least)} % of the faults or more"
        else s"the vectors of $weak units find too few faults",
        weak == 0,
        Seq(file) ++ files.find("mutate.csv") ++ files.find("index.html")
      )
    }
  )

  private val Head = Seq("unit", "broken wires", "found by the test vectors", "shown to change nothing", "found, %")
}
