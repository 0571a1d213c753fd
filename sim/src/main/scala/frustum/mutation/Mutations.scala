package frustum.mutation

import frustum.boards.flow.{FlowFault, Tool}
import frustum.synthesis.UnitVerilog
import java.nio.file.{Files, Path}
import scala.jdk.CollectionConverters._
import spinal.core.Component

/** One wrong wire. */
final case class Mutant(number: Int, mode: String, cell: String, port: String, source: String) {
  override def toString: String = s"$number: $mode at $port of $cell ($source)"
}

/** A unit's netlist with many mutants in one, by yosys.
  *
  * @param folder where everything is put
  */
final class Mutations(yosys: Tool, folder: Path) {
  private def script(log: String, commands: String): Unit =
    if (yosys.run(folder, log, Seq("-p", commands)) != 0)
      throw FlowFault(s"yosys: ${Tool.faults(folder.resolve(log))} (${folder.resolve(log)})")

  /** Writes `<name>.mutants.v` and `.il`, with the port `mutsel`; gives the unit's ports and the mutants. */
  def make(name: String, count: Int, seed: Long)(unit: => Component): (Seq[UnitPort], Seq[Mutant]) = {
    require(count <= MutantNetlist.Most, s"$count mutants, at most ${MutantNetlist.Most}")
    val ports = UnitPort.of(UnitVerilog.write(folder, name)(unit))
    val coarse =
      "proc; flatten; opt -full; wreduce; opt_clean; memory_dff; memory_collect; pmuxtree; opt_clean"
    script(
      s"$name.list.log",
      s"read_verilog $name.v; hierarchy -top $name; $coarse; write_rtlil $name.il; " +
        s"mutate -list $count -seed $seed -none -ctrl mutsel ${MutantNetlist.SelectBits} 0 -o $name.list"
    )
    // An edge of the clock is no value.
    val list =
      Files.readAllLines(folder.resolve(s"$name.list")).asScala.toSeq.filterNot(_.contains("-port CLK"))
    Files.writeString(folder.resolve(s"$name.ys"), list.mkString("", "\n", "\n"))
    script(
      s"$name.mutants.log",
      // Verilator 5.006 loses bits of vectors that are driven in parts: nets are split.
      s"read_rtlil $name.il; script $name.ys; opt_clean; splitnets; clean; write_rtlil $name.mutants.il; " +
        s"write_verilog -noattr $name.mutants.v"
    )
    val mutants = list.tail.map(_.split(' ').toSeq).map { words =>
      def after(key: String) = words.indexOf(key) match { case -1 => ""; case i => words(i + 1) }
      val by = if (after("-ctrlbit").isEmpty) "" else s" by ${after("-ctrlbit")}"
      val place = s"${after("-port")}[${after("-portbit")}$by]"
      Mutant(words(words.indexOf("-ctrl") + 3).toInt, after("-mode"), after("-cell"), place, after("-wire"))
    }
    (ports, mutants)
  }

  /** Whether a mutant is shown to do what the unit does, whatever comes in, from registers and memories that are zero:
    * by ABC's signal correspondence (van Eijk, 2000), an induction over what is equal in both.
    */
  def isEquivalent(name: String, mutant: Int): Boolean = {
    val halves = Seq("gold" -> 0, "gate" -> mutant).map { case (half, select) =>
      s"design -load both; delete -input $name/w:mutsel; connect -set mutsel ${MutantNetlist.SelectBits}'d$select; " +
        s"rename $name $half; design -stash $half; "
    }.mkString
    val commands =
      s"read_rtlil $name.mutants.il; memory_map; simplemap t:*dff*; dffunmap; opt_clean; design -save both; $halves" +
        "design -copy-from gold gold; design -copy-from gate gate; miter -equiv -flatten -make_outputs gold gate " +
        "miter; hierarchy -top miter; delete -output miter/o:gold_* miter/o:gate_*; techmap; opt -nodffe -nosdff; " +
        "setundef -zero; abc -dff -g AND -script +strash;zero;scorr;dc2;scorr;strash;fraig; opt -nodffe -nosdff; " +
        "delete t:$scopeinfo; select -assert-none t:*"
    Files.writeString(folder.resolve(s"$name.equivalent.ys"), commands.replace("; ", "\n") + "\n")
    yosys.run(folder, s"$name.$mutant.equivalent.log", Seq("-s", s"$name.equivalent.ys")) == 0
  }
}
