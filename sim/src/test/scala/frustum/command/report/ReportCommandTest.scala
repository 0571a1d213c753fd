package frustum.command.report

import frustum.command.CommandRunner
import frustum.picture.{AnimatedGif, Picture}
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.{Files, Path}

/** `report`: one page that needs nothing beside it, of what there is; what there is not is named with its command. */
class ReportCommandTest extends AnyFunSuite {
  private def folder(): Path = Files.createTempDirectory("report")
  private def put(file: Path, text: String): Unit = {
    Files.createDirectories(file.getParent)
    Files.writeString(file, text)
  }
  private def picture(file: Path, width: Int, height: Int): Unit =
    Picture.writePng(file, width, height, Array.fill(width * height)(0x4080c0))

  private def run(from: Path, out: Path) = CommandRunner.run("report", "--from", s"$from", "--out", s"$out")
  private def page(out: Path) = Files.readString(out.resolve("index.html"))

  private def demo(from: Path, pixelsDifferent: Int = 0): Unit = {
    put(
      from.resolve("demo/cube.json"),
      s"""{"engine": "model", "scene": "cube", "width": 24, "height": 32, "trianglesDrawn": 12,
         |"hardwareVsModel": {"pixelsDifferent": $pixelsDifferent},
        |"modelVsReference": {"coverageWrong": 0, "psnr": 40},
         |"endToEnd": {"referee": "world", "primitiveWrong": 0, "texelsWrong": 3,
        |"psnr": 39, "flip": 0.01}}""".stripMargin
    )
    for (kind <- Seq("", ".reference", ".difference", ".referee"))
      picture(from.resolve(s"demo/cube$kind.png"), 24, 32)
    put(
      from.resolve("demo/pong.json"),
      """{"engine": "model", "scene": "pong", "width": 64, "height": 48, "objectPixelsWrong": 0, "psnr": null}"""
    )
    picture(from.resolve("demo/pong.png"), 64, 48)
    AnimatedGif.write(from.resolve("demo/pong.gif"), 64, 48)(_.add(new Array[Int](64 * 48), 3))
  }

  private def all(from: Path): Unit = {
    demo(from)
    picture(from.resolve("chart/leaps-2.png"), 96, 60)
    put(
      from.resolve("chart/chart.json"),
      """{"charts": [{"name": "leaps-2", "title": "Leaps & bounds", "note": "Less is better.", "costAxis": "bits",
        |"errorAxis": "steps"}]}""".stripMargin
    )
    picture(from.resolve("chart/old-family.png"), 96, 60)
    picture(from.resolve("chart/systems/systems-cube.png"), 96, 60)
    put(from.resolve("chart/systems/systems.json"), """{"charts": [{"name": "systems-cube"}]}""")
    picture(from.resolve("stability/map.png"), 96, 60)
    put(
      from.resolve("stability/stability.json"),
      """{"failures": [], "sweeps": [{"method": "depth", "quantity": "range", "unit": "far/near", "bound": 0.5,
        |"validFor": {"low": 1, "high": 300}, "errorUnit": "steps", "worst": 0.123456789}]}""".stripMargin
    )
    put(
      from.resolve("budgets/budgets.json"),
      """{"failures": ["cube: endToEnd.psnr is 38.00001, its bound 39.0"], "budgets": [
        |{"scene": "cube", "metric": "endToEnd.psnr", "bound": 39, "today": 38.00001, "met": false},
        |{"scene": "cube", "metric": "endToEnd.texelsWrong", "bound": 5, "today": 3, "met": true}]}""".stripMargin
    )
    put(
      from.resolve("bench/raster.json"),
      """{"seed": 1, "setupClocks": 545.25, "rightTriangleClocks": {"8": 31}, "newThing": 7}"""
    )
    put(
      from.resolve("bitstream/icebreaker-pong.json"),
      """{"top": "icebreaker-pong", "part": "iCE40UP5K", "fits": true, "logicCells": 4216, "ebr": 12, "dsp": 8,
        |"clockMHz": {"min": 38.21234, "max": 40, "seeds": [38.21234, 40]},
        |"targetMHz": 25.125, "meetsTarget": true}""".stripMargin
    )
    put(
      from.resolve("fit/cube.json"),
      """{"met": true, "logicCells": 3365, "heldOutViews": 64, "heldOutOverBudget": 0}"""
    )
    put(
      from.resolve("mutate/mutate.json"),
      """{"units": [{"unit": "blend", "mutants": 400, "killed": 390, "equivalent": 8, "killPercent": 99.5}]}"""
    )
    put(
      from.resolve("voxel/voxel.json"),
      """{"engine": "model", "scene": "voxel", "width": 32, "height": 24, "psnr": 30}"""
    )
    picture(from.resolve("voxel/voxel.png"), 32, 24)
  }

  test("nothing was run: the page names every part with the command that makes it") {
    val (from, out) = (folder(), folder().resolve("page"))
    val done = run(from, out)
    assert(done.code == 0 && done.err.isEmpty, done)
    for (part <- ReportPart.all) {
      assert(done.out.contains(s"not run yet: ./sbt \"${part.command}\""), part.title)
      assert(page(out).contains(part.command), part.title)
    }
    assert(done.out.contains(s"report: ${ReportPart.all.length} of ${ReportPart.all.length}"))
  }

  test("everything was run: verdicts, names and figures, pictures within the page, no network") {
    val (from, out) = (folder(), folder())
    all(from)
    val done = run(from, out)
    assert(done.code == 0 && done.err.isEmpty, done)
    val html = page(out)
    val pictures = "<img[^>]*?src=\"([^\"]*)\"".r.findAllMatchIn(html.replace("\n", " ")).map(_.group(1)).toSeq
    assert(pictures.length == 11 && pictures.forall(_.startsWith("data:image/")))
    assert(pictures.exists(_.startsWith("data:image/gif")))
    assert(!"(?i)https?:|<script|<link|@import|url\\(".r.findFirstIn(html).isDefined)
    for (
      said <- Seq(
        "2 scenes, all as they should be",
        "Leaps &amp; bounds",
        "1 of 2 bounds are met",
        "at least 39",
        "missed",
        "set-up of a triangle: cycles",
        "new thing",
        "38.21",
        "1 of 1 fit and reach their clock",
        "1 of 1 within their budget",
        "find 95 % of the faults or more",
        "0.1235"
      )
    ) assert(html.contains(said), said)
    assert(!html.contains("endToEnd.") && !html.contains("38.21234"))
  }

  test("every link goes to a copy that lies beside the page") {
    val (from, out) = (folder(), folder())
    all(from)
    put(out.resolve("data/demo/gone.json"), "{}")
    run(from, out)
    val places = "href=\"(data/[^\"]*)\"".r.findAllMatchIn(page(out)).map(_.group(1)).toSeq
    assert(places.contains("data/demo/cube.json") && places.contains("data/chart/chart.json"))
    assert(places.contains("data/chart/systems/systems.json"))
    assert(Files.isRegularFile(out.resolve("data/demo/pong.gif")), "pictures are copied too")
    for (place <- places) assert(Files.isRegularFile(out.resolve(place)), place)
    assert(!Files.exists(out.resolve("data/demo/gone.json")), "a copy of a file that is no longer there")
  }

  test("a scene that is not the model's is told") {
    val (from, out) = (folder(), folder())
    demo(from, pixelsDifferent = 3)
    run(from, out)
    assert(page(out).contains("wrong: cube"))
  }

  for ((name, text) <- Seq("no JSON" -> "{", "another report" -> """{"scene": "cube"}""", "a list" -> "[]"))
    test(s"$name in place of a report: one line that names file and remedy, and no page") {
      val (from, out) = (folder(), folder())
      put(from.resolve("budgets/budgets.json"), text)
      val done = run(from, out)
      assert(done.code == 2 && done.err.length == 1, done)
      assert(done.err.head.startsWith("error: ") && done.err.head.contains("budgets.json"), done)
      assert(done.err.head.contains("run ./sbt \"budgets\" again"), done)
      assert(!Files.exists(out.resolve("index.html")))
    }

  test("the report's own copies are not what it is made of") {
    val out = folder()
    val done = run(out.resolve("data"), out)
    assert(done.code == 2 && done.err.length == 1 && done.err.head.contains("--from"), done)
  }
}
