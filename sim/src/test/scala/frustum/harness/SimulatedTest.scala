package frustum.harness

import frustum.engine.VerilatorSettings
import org.scalatest.Filter
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.{Files, Path, Paths}
import scala.jdk.CollectionConverters._
import scala.util.Using

/** `./sbt quick` leaves out the tests that simulate, and finds those that do so without the mark. */
class SimulatedTest extends AnyFunSuite {
  private val quick = Filter(tagsToExclude = Set(Simulated.name))

  test("the mark of a suite is on all of its tests, that of a test on this test alone; other marks stay") {
    class Whole extends AnyFunSuite with Simulated {
      test("one")(())
      test("two", Formal)(())
    }
    class Part extends AnyFunSuite {
      test("one", Simulated)(())
      test("two")(())
    }
    assert(new Whole().expectedTestCount(quick) == 0)
    assert(new Whole().tags("two") == Set(Simulated.name, Formal.name))
    assert(new Part().expectedTestCount(quick) == 1)
  }

  test("a simulation that is switched off is refused, and the message names the mark") {
    val refused = intercept[IllegalStateException](VerilatorSettings(FrustumSim.spinalConfig, Some("off")))
    assert(refused.getMessage.contains("Simulated"))
  }

  test("every simulation takes its settings where it can be refused") {
    def sources(folder: Path): Seq[Path] =
      Using.resource(Files.walk(folder))(_.iterator.asScala.filter(_.toString.endsWith(".scala")).toSeq)
    val roots = Using.resource(Files.list(Paths.get("")))(_.iterator.asScala.toSeq).map(_.resolve("src"))
    val own = """\b(SimConfig|SpinalVerilatorBackend|SimVerilator)\b""".r
    val found = roots.filter(Files.isDirectory(_)).flatMap(sources).filter { file =>
      own.findFirstIn(Files.readString(file)).isDefined
    }
    assert(found.map(_.getFileName.toString).sorted == Seq("SimulatedTest.scala", "VerilatorSettings.scala"))
  }
}
