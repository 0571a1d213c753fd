package frustum.command.demo

import frustum.command.CommandRunner
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files

/** The page of `demo`, drawn by the models. */
class DemoPageTest extends AnyFunSuite {
  private lazy val (page, folder) = {
    val folder = Files.createTempDirectory("demo")
    val run = CommandRunner.run("demo", "--engine", "model", "--out", s"$folder")
    assert(run.code == 0 && run.err.isEmpty, run)
    (Files.readString(folder.resolve("index.html")).replace("\n", " "), folder)
  }
  private def found(pattern: String) = pattern.r.findAllMatchIn(page).map(_.group(1)).toSeq

  test("all pictures are of one height, pong's moving one among them") {
    val heights = found("<img[^>]*? height=\"(\\d+)\"")
    assert(heights.length == 5 * 4 + 4 + 3 && heights.distinct.length == 1, heights)
    assert(found("src=\"(data:image/gif)").length == 1)
  }

  test("every figure that is shown has a legend") {
    val figures = found("<div title=\"[^\"]+\"><dt>([^<]*)</dt>").distinct
    val legend = found("<dt>([^<]*)</dt><dd>[A-Za-z]").toSet
    for (name <- Seq("FLIP", "order wrong", "end to end wrong")) assert(figures.contains(name), name)
    for (figure <- figures) assert(legend(figure), figure)
  }

  test("the model's pong is judged as the hardware's is, and has no figures of pins") {
    val report = ujson.read(Files.readString(folder.resolve("pong.json")))
    assert(report("engine").str == "model" && report("frames").num == 16 && report("objectPixelsWrong").num == 0)
    assert(!report.obj.contains("clocksPerFrame") && !report.obj.contains("hardwareVsModel"))
  }
}
