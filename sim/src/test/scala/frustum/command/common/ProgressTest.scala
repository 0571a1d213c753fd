package frustum.command.common

import org.scalatest.funsuite.AnyFunSuite
import java.io.ByteArrayOutputStream

class ProgressTest extends AnyFunSuite {
  private def lines(steps: Int): Seq[String] = {
    val out = new ByteArrayOutputStream
    Console.withOut(out) {
      val progress = Progress("work", steps)
      for (_ <- 0 until steps) progress.step()
      progress.close()
    }
    out.toString.linesIterator.toSeq
  }

  test("without a terminal few steps have a line each, many have evenly spread ones, the last among them") {
    assume(System.console == null, "there is a terminal")
    assert(lines(3) == Seq("work: 1 of 3", "work: 2 of 3", "work: 3 of 3"))
    assert(lines(Progress.Lines).length == Progress.Lines)
    for (steps <- Seq(21, 100, 399)) {
      val said = lines(steps)
      assert(said.length == Progress.Lines && said.last == s"work: $steps of $steps", said)
    }
  }

  test("numbers as a person writes them") {
    assert(Figure(1234567) == "1,234,567" && Figure(0.123456789) == "0.1235" && Figure(-2.50) == "-2.5")
    assert(Figure(48.08475402, digits = 6) == "48.0848" && Figure(123456.7) == "123,500")
    assert(Figure.words("fullScreenClocksPerPixel") == "full screen clocks per pixel")
  }
}
