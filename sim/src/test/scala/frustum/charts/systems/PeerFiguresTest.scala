package frustum.charts.systems

import frustum.contract.InputError
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files

class PeerFiguresTest extends AnyFunSuite {
  test("the compared system's figures are those of docs/results.md") {
    val p = PeerFigures.read()
    assert(p.name == "Rasterix" && p.clockMHz == (25.0, 27.6) && p.logicCells == (4692.0, 4692.0))
    assert(p.cubeCycles == (282000.0, 310000.0) && p.cyclesPerPixel == (2.09, 2.09))
    assert(p.quadTexelsWrong == (11.6, 16.6) && p.floorTexelsWrong == (27.0, 33.0))
  }

  test("frames a second: the slowest clock with most cycles, the fastest with least") {
    val (slow, fast) = PeerFigures.read().framesPerSecond((282000, 310000))
    assert((slow - 80.645).abs < 0.001 && (fast - 97.872).abs < 0.001)
  }

  test("a page without the figures is an error that names it") {
    val page = Files.createTempFile("results", ".md")
    Files.writeString(page, "| | here | Rasterix |\n| --- | --- | --- |\n| cells | 1 | 2 |\n")
    val error = intercept[InputError](PeerFigures.read(page))
    assert(error.getMessage.contains(page.toString) && error.getMessage.contains("clockMHz"))
  }
}
