package frustum.command.common

import frustum.command.CommandRunner
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.{Files, Paths}

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

  for (command <- Seq("verilog", "bitstream")) test(s"refused: $command where out is a file") {
    val folder = Files.createTempDirectory("no-out")
    Files.writeString(folder.resolve("out"), "a file")
    val errors = folder.resolve("stderr").toFile
    val java = Paths.get(System.getProperty("java.home"), "bin", "java").toString
    val code = new ProcessBuilder(
      java,
      "-cp",
      System.getProperty("java.class.path"),
      "frustum.command.Main",
      command,
      "icebreaker-pong"
    )
      .directory(folder.toFile).redirectOutput(ProcessBuilder.Redirect.DISCARD).redirectError(errors).start().waitFor()
    val lines = Files.readAllLines(errors.toPath)
    assert(code == 2 && lines.size == 1, lines)
    assert(
      lines.get(0).startsWith("error: ") && lines.get(0).contains("out") && lines.get(0).contains("writable folder"),
      lines
    )
  }
}
