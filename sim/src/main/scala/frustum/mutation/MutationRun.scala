package frustum.mutation

import frustum.boards.flow.Tool
import frustum.engine.{EngineSim, VerilatorSettings}
import frustum.files.OutputFile
import java.nio.file.Path
import spinal.core.sim._

/** What became of a unit's mutants. */
final case class MutationResult(
    name: String,
    steps: Int,
    killed: Seq[Mutant],
    equivalent: Seq[Mutant],
    survivors: Seq[Mutant]
) {
  val count: Int = killed.length + equivalent.length + survivors.length

  /** Of those that differ from the unit at all, as far as it can be shown. */
  def killPercent: Double = 100.0 * killed.length / (count - equivalent.length).max(1)
}

/** Runs a plan on every mutant of its unit, all in one compiled simulation.
  *
  * @param say   told of each step
  * @param watch told what is done with how many mutants, and called after each of them
  */
final class MutationRun(yosys: Tool, folder: Path, say: String => Unit, watch: (String, Int) => () => Unit) {
  private val mutations = new Mutations(yosys, folder)

  def apply(plan: MutationPlan, count: Int, seed: Long): MutationResult = {
    OutputFile.folder(folder)
    val (ports, mutants) = mutations.make(plan.name, count, seed)(plan.unit())
    say(s"${plan.name}: ${mutants.length} mutants, ${plan.steps.length} steps")
    val file = folder.resolve(s"${plan.name}.mutants.v").toAbsolutePath.toString
    val sim = VerilatorSettings(EngineSim.spinalConfig).workspacePath(folder.toString)
      .workspaceName(s"${plan.name}-sim").compile(new MutationBench(plan, ports, file))
    var kills = Seq.empty[Mutant]
    sim.doSim("mutants", seed.toInt) { dut =>
      if (fails(dut, 0))
        throw new IllegalStateException(
          s"${plan.name}: the netlist without a mutation does not do what its model does"
        )
      val tried = watch(s"${plan.name}, simulating mutants", mutants.length)
      kills = mutants.filter { m =>
        val fault = fails(dut, m.number)
        tried()
        fault
      }
    }
    val alive = mutants.diff(kills)
    say(s"${plan.name}: ${kills.length} killed, comparing the other ${alive.length} with the unit by proof")
    val compared = watch(s"${plan.name}, comparing with the unit", alive.length)
    val (equivalent, survivors) = alive.partition { m =>
      val same = mutations.isEquivalent(plan.name, m.number)
      compared()
      same
    }
    MutationResult(plan.name, plan.steps.length, kills, equivalent, survivors)
  }

  private def fails(dut: MutationBench, mutant: Int): Boolean = {
    val clock = dut.clockDomain
    if (mutant == 0) clock.forkStimulus(MutationRun.Period)
    dut.io.select #= mutant
    for (clocks <- Seq(MutationRun.Prelude, 1)) { // a reset in the midst of work, which has to forget it
      clock.assertReset()
      sleep(4 * MutationRun.Period)
      clock.deassertReset()
      sleep(clocks * MutationRun.Period)
    }
    var left = MutationRun.Patience
    while (!dut.io.failed.toBoolean && !dut.io.done.toBoolean && left > 0) {
      sleep(MutationRun.Chunk * MutationRun.Period)
      left -= 1
    }
    dut.io.failed.toBoolean || left == 0
  }
}

object MutationRun {
  private val Period = 10L

  /** Clocks before the reset that counts. */
  private val Prelude = 777L

  /** Clocks between two looks, and looks until a run that goes on and on is given up. */
  private val Chunk = 256
  private val Patience = 20000
}
