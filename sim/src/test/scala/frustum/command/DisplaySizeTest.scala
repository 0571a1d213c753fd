package frustum.command

import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files

/** Pictures that the display of a top cannot show are refused in one line before anything is simulated. */
class DisplaySizeTest extends AnyFunSuite {
  private val folder = Files.createTempDirectory("display-size")
  private val table = Seq(
    "render --scene cube --size 400x300" -> Seq("--size 400x300", "240 x 320", "--engine pipeline"),
    "render --scene cube --panel st7789-135x240" -> Seq("--size 240x320", "135 x 240", "--engine pipeline"),
    "render --scene cube --panel st7789-240x240 --size 240x280" -> Seq("--size 240x280", "240 x 240"),
    "fit --scene cube --texels-wrong 1 --size 400x300" -> Seq("--size 400x300", "240 x 320", "--no-synthesis")
  )
  for ((line, fragments) <- table) test(s"refused: $line") {
    val run = CommandRunner.run(line.split(' ').toSeq ++ Seq("--out", folder.resolve("refused.png").toString): _*)
    assert(run.code == 2 && run.err.length == 1 && run.err.head.startsWith("error: "), run)
    fragments.foreach(f => assert(run.err.head.contains(f), run.err.head))
    assert(folder.toFile.list().isEmpty)
  }
}
