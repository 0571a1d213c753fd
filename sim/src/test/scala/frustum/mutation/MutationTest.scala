package frustum.mutation

import frustum.boards.flow.{Ice40Tools, MissingTool, Tool}
import frustum.command.CommandRunner
import frustum.harness.{Simulated, Synthesised}
import java.nio.file.Paths
import org.scalatest.funsuite.AnyFunSuite
import scala.collection.mutable

/** The vectors of `mutate`: the unit without a mutation does what its model says, and few mutants do. */
class MutationTest extends AnyFunSuite {
  private lazy val yosys: Tool =
    try Ice40Tools.find(_ => ()).yosys
    catch { case MissingTool(notice) => cancel(s"nothing is mutated: $notice") }

  private val folder = Paths.get("simWorkspace", "mutation")

  test(
    "depth test: 40 mutants, of which nearly all are found; what is left is compared with the unit",
    Simulated,
    Synthesised
  ) {
    val watched = mutable.LinkedHashMap.empty[String, (Int, Int)] // by task: mutants told, mutants done
    def watch(task: String, mutants: Int): () => Unit = {
      watched(task) = (mutants, 0)
      () => watched(task) = watched(task).copy(_2 = watched(task)._2 + 1)
    }
    val r = new MutationRun(yosys, folder, info(_), watch)(DepthStagePlan(1), 40, seed = 2)
    assert(
      watched.values.toSeq == Seq((r.count, r.count), (r.count - r.killed.length, r.count - r.killed.length)),
      watched
    )
    assert(r.count > 30 && r.killed.length >= 0.75 * r.count, r)
    assert(r.killPercent >= 90, r)
  }

  test("a mutant that makes no difference is shown to make none, one that does is not", Synthesised) {
    val mutations = new Mutations(yosys, folder)
    val (ports, mutants) = mutations.make("EdgeWalker", 4, seed = 1)(EdgeWalkerPlan.serial(1).unit())
    assert(ports.exists(p => p.name == "io_up_valid" && !p.isInput && p.width == 1))
    assert(mutations.isEquivalent("EdgeWalker", 0)) // none at all
    assert(!mutants.forall(m => mutations.isEquivalent("EdgeWalker", m.number)))
  }

  for ((words, part) <- Seq(Seq("mutate", "luck") -> "edge-walker", Seq("mutate", "--mutants", "5000") -> "4095"))
    test(s"refused: ${words.mkString(" ")}") {
      val run = CommandRunner.run(words: _*)
      assert(run.code == 2 && run.err.length == 1 && run.err.head.contains(part), run)
    }
}
