package frustum.command.common

import frustum.command.CommandRunner
import org.scalatest.funsuite.AnyFunSuite

class TopArgumentsTest extends AnyFunSuite {
  private val table = Seq(
    "bitstream" -> Seq("TOP is missing", "icebreaker-raster"),
    "bitstream icestick-raster" -> Seq("icestick-raster", "icebreaker-raster"),
    "bitstream icebreaker-raster --seeds 0" -> Seq("--seeds", "1..100"),
    "bitstream icebreaker-raster --placer rapid" -> Seq("--placer", "rapid", "static, heap"),
    "verilog icebreaker-raster --seeds 2" -> Seq("--seeds")
  )

  for ((line, fragments) <- table) test(s"refused: $line") {
    val run = CommandRunner.run(line.split(' ').toSeq: _*)
    assert(run.code == 2, run)
    assert(run.err.length == 1 && run.err.head.startsWith("error: "), run)
    fragments.foreach(f => assert(run.err.head.contains(f), run.err.head))
  }
}
