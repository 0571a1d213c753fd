package frustum.stability

import frustum.command.CommandRunner
import frustum.contract.{InputError, ValidFor}
import java.nio.file.Files
import javax.imageio.ImageIO
import org.scalatest.funsuite.AnyFunSuite
import scala.math.{exp, log}
import scala.util.Random

/** Every method keeps its bound where it is declared valid, and is nowhere broken in silence; the search for borders
  * finds them.
  */
class StabilityTest extends AnyFunSuite {
  private val seed = 1

  /** Values of the declared domain, its ends and their neighbourhood among them. */
  private def inside(s: Sweep, random: Random): Seq[Double] = {
    val (low, high) = (s.domain.low.max(s.from), s.domain.high.min(s.to))
    def pick(f: Double) =
      if (s.whole) scala.math.rint(low + f * (high - low))
      else exp(log(low) + f * (log(high) - log(low))).max(low).min(high)
    Seq(0, 1, 0.01, 0.99, random.nextDouble(), random.nextDouble()).map(pick).distinct
  }

  for (s <- Sweep.all) test(s"${s.domain.method}, ${s.name}: keeps its bound where it is declared") {
    for (value <- inside(s, new Random(seed))) {
      val trial = s.at(value)
      assert(trial.state == Stability.Safe, s"$trial, bound ${s.domain.bound}, seed $seed")
    }
  }

  for (s <- Sweep.all) test(s"${s.domain.method}, ${s.name}: beyond, it is refused or still of use") {
    val random = new Random(seed)
    val beyond = Seq(s.from, s.to) ++ Seq.fill(2)(
      if (s.whole) random.between(s.from.toInt, s.to.toInt + 1).toDouble
      else exp(log(s.from) + random.nextDouble() * (log(s.to) - log(s.from)))
    )
    for (value <- beyond.filterNot(s.domain.contains)) {
      val trial = s.at(value)
      assert(trial.state != Stability.Broken, s"$trial, seed $seed")
      assert(
        trial.state != Stability.Refused || trial.reason.exists(_.exists(_.isDigit)),
        s"$trial: no numbers"
      )
    }
  }

  private val line = ValidFor("fake", "line", "units", 1, 10, 1, "units")

  test("bisection finds where a method leaves its bound, breaks and is refused") {
    val found = Sweep(line, 1, 1000, broken = 2) { v =>
      if (v > 500) throw InputError(s"$v is more than 500")
      if (v < 40) 0.5 else if (v < 300) 1.5 else 3
    }.run(5)
    assert(found.borders.map(b => (b.below.name, b.above.name)) ==
      Seq("safe" -> "degraded", "degraded" -> "broken", "broken" -> "refused"))
    for ((border, at) <- found.borders.zip(Seq(40, 300, 500)))
      assert((border.value / at - 1).abs < 0.02, border)
    assert(found.stretches.map(_._3.name) == Seq("safe", "degraded", "broken", "refused"))
    assert(found.failures.nonEmpty && found.failures.forall(_.contains("drawn broken")))
  }

  test("whole numbers: the border is the first value of the new state") {
    val found =
      Sweep(line.copy(high = 17), 0, 100, broken = 9, whole = true)(v => if (v <= 17) 0 else 2).run()
    assert(found.borders == Seq(Border(18, Stability.Safe, Stability.Degraded)) && found.failures.isEmpty)
  }

  test("a broken promise is told; faults of the method itself are not taken for refusals") {
    val found = Sweep(line, 1, 100, broken = 9)(v => if (v > 5) 2 else 0).run()
    assert(found.failures.exists(_.contains("line 10.0 is in the declared domain and degraded")))
    intercept[IllegalStateException](Sweep(line, 1, 100, 9)(_ => throw new IllegalStateException).run())
  }

  test("the command writes a map, data and a page; an unknown method is refused") {
    val out = Files.createTempDirectory("stability")
    val run = CommandRunner.run("stability", "march", "--out", out.toString)
    assert(run.code == 0, run)
    assert(ImageIO.read(out.resolve("map.png").toFile).getWidth > 500)
    val report = ujson.read(Files.readString(out.resolve("stability.json")))
    assert(report("sweeps").arr.map(_("quantity").str) == Seq("focal-length", "eye-outside", "view-distance"))
    assert(report("failures").arr.isEmpty)
    assert(Files.readString(out.resolve("stability.csv")).linesIterator.length > 40)
    assert(Files.readString(out.resolve("index.html")).contains("eye-outside"))
    val wrong = CommandRunner.run("stability", "luck")
    assert(wrong.code == 2 && wrong.err.exists(_.contains("perspective")))
  }
}
