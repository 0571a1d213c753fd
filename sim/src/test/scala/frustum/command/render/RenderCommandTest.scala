package frustum.command.render

import frustum.budgets.{Budget, BudgetTable}
import frustum.command.CommandRunner
import frustum.command.common.Clock
import frustum.contract.raster.{RasterConfig, Wrap}
import frustum.driver.raster.{DrawOptions, Driver}
import frustum.engine.raster.{PassEngine, ReferenceRenderer, RenderedFrame}
import frustum.judge.{EndToEndJudge, FrameJudge}
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files
import javax.imageio.ImageIO

class RenderCommandTest extends AnyFunSuite {
  private val small = RasterConfig(width = 64, height = 48)

  test("render writes a picture of the size asked for and a report") {
    val folder = Files.createTempDirectory("render")
    val run = CommandRunner.run(
      "--line",
      s"render --scene cube --engine reference --size 64x48 --eye -1,2,3 --light 1,1,1" +
        s" --cull back --background 204060 --out '$folder/a b.png' --report $folder/r.json"
    )
    assert(run.code == 0 && run.err.isEmpty, run)
    val picture = ImageIO.read(folder.resolve("a b.png").toFile)
    assert(picture.getWidth == 64 && picture.getHeight == 48)
    val report = ujson.read(Files.readString(folder.resolve("r.json")))
    for (
      key <- Seq(
        "command",
        "version",
        "seed",
        "engine",
        "scene",
        "width",
        "height",
        "triangles",
        "trianglesDrawn",
        "fragments",
        "passes",
        "busBytes"
      )
    ) assert(report.obj.contains(key), key)
    for (key <- Seq("coverageWrong", "texelsWrong", "psnr", "flip"))
      assert(report("snapping").obj.contains(key), key)
    for (key <- Seq("primitiveWrong", "texelsWrong", "judged", "psnr", "flip"))
      assert(report("endToEnd").obj.contains(key), key)
    assert(Seq(
      "llvmpipe",
      "world"
    ).contains(report("endToEnd")("referee").str) && report("endToEnd")("judged").num > 2000)
    assert(Seq(
      "modelVsReference",
      "hardwareVsModel",
      "clocksPerFrame",
      "clockMHz"
    ).forall(!report.obj.contains(_)))
    assert(report("triangles").num == 12 && report("trianglesDrawn").num == 6)
    assert(report("trianglesFacingAway").num == 6 && report("trianglesWithoutArea").num == 0)
  }

  test("an animation has a picture for each frame, and they differ") {
    val folder = Files.createTempDirectory("render")
    val run = CommandRunner.run(
      "render",
      "--scene",
      "cube",
      "--engine",
      "reference",
      "--size",
      "32x32",
      "--frames",
      "3",
      "--turn",
      "20",
      "--out",
      s"$folder/%d.png",
      "--report",
      s"$folder/r.json"
    )
    assert(run.code == 0, run)
    val pictures = (0 until 3).map(i => Files.readAllBytes(folder.resolve(s"$i.png")).toSeq)
    assert(pictures.distinct.length == 3)
  }

  /** What a simulated engine leads to, with the reference in its place and `faults` pixels of its picture
    * wrong.
    */
  private def figures(faults: Int): SceneFigures = {
    val scene = Scenes.cube
    val options = DrawOptions(None, cullBack = false, Wrap.Repeat, 0)
    val frame = Driver.prepare(scene, scene.camera, options, small, 0)
    val view = EndToEndJudge.view(scene, scene.camera, options, small)
    val drawn = new PassEngine(new ReferenceRenderer(_)).drawAll(Seq(frame)).head
    for (i <- 0 until faults) drawn.image(i) ^= 1
    val timed = RenderedFrame(drawn.image, Some(5000), Some(9000), drawn.busBytes)
    val verdict = new FrameJudge(Some(new ReferenceRenderer(_)), simulated = true).judge(frame, timed, Some(view))
    SceneFigures("cube", "hardware", small, Seq(FrameFigures(frame, timed, verdict)), 1.0)
  }

  test("the report of a simulated engine has every key") {
    val report = RenderReport.json("render", 7, figures(0), Clock(40, "placed"))
    for (
      key <- Seq(
        "clocksPerFrame",
        "clocksPerFrameAtPins",
        "clocksPerFragment",
        "busBytes",
        "passes",
        "clockMHz",
        "clockSource",
        "framesPerSecond",
        "framesPerSecondAtPins"
      )
    ) assert(report.obj.contains(key), key)
    for (
      key <- Seq(
        "coverageWrong",
        "texelsJudged",
        "texelsWrong",
        "texelsWrongByMoreThanOne",
        "maxTexelError",
        "primitiveWrong",
        "depthOrderWrong",
        "psnr"
      )
    ) assert(report("modelVsReference").obj.contains(key), key)
    assert(report("hardwareVsModel")("pixelsDifferent").num == 0 && report("framesPerSecond").num == 8000)
    assert(report("modelVsReference")("coverageWrong").num == 0 && report("modelVsReference")(
      "texelsWrong"
    ).num == 0)
    // Texels shown as they are survive RGB565 without loss.
    assert(report("modelVsReference")("psnr").isNull && report("endToEnd")("psnr").num > 20)
  }

  test("a picture that is not the model's is a failure with exit code 1") {
    val report = java.nio.file.Paths.get("r.json")
    assert(figures(0).verdict(report) == 0)
    assert(figures(3).pixelsDifferent.contains(3L))
    Console.withErr(new java.io.ByteArrayOutputStream)(assert(figures(3).verdict(report) == 1))
  }

  test("a picture beyond the referee's bound is a failure with exit code 1") {
    val good = figures(0)
    val e = good.endToEnd.get
    val table = Files.createTempFile("budgets", ".json")
    BudgetTable(Seq(Budget(Budget.AnyPicture, "endToEnd.unexplainedPercent", bound = 0.05, today = 0))).write(table)
    def beyond(wrong: Long) = {
      val sum = e.copy(world = e.world.copy(primitiveUnexplained = wrong))
      EndToEndBounds.failures(EndToEndBounds.ofAny(sum), sum, table)
    }
    assert(beyond(0).isEmpty && beyond(30).length == 1)
    val apart = e.copy(counts = e.counts.copy(referee = "llvmpipe", refereesDiffer = e.counts.judged / 10))
    assert(EndToEndBounds.failures(
      EndToEndBounds.ofAny(apart),
      apart,
      table
    ).head.contains("llvmpipe and float64 differ"))
    val report = java.nio.file.Paths.get("r.json")
    val err = new java.io.ByteArrayOutputStream
    Console.withErr(err)(assert(good.verdict(report, beyond(30)) == 1))
    assert(err.toString.startsWith(
      "error: cube: end to end: unexplainedPercent is"
    ) && err.toString.linesIterator.length == 1)
  }

  test("an infinite PSNR is null") {
    val perfect = figures(0)
    val equal = perfect.copy(frames = perfect.frames.map(_.copy(squaredError = 0)))
    assert(RenderReport.json("render", 1, equal)("modelVsReference")("psnr").isNull)
  }

  test("demo writes page, pictures and reports") {
    val folder = Files.createTempDirectory("demo")
    val run = CommandRunner.run("demo", "--engine", "reference", "--out", folder.toString)
    assert(run.code == 0 && Scenes.names.forall(run.out.contains), run)
    for (s <- Scenes.names; kind <- Seq(".png", ".reference.png", ".difference.png", ".json"))
      assert(Files.size(folder.resolve(s + kind)) > 100, s + kind)
    val page = Files.readString(folder.resolve("index.html"))
    assert(page.contains("data:image/png;base64,") && !page.contains("src=\"http"))
  }

  test("the clock is the placed one where there is a report") {
    val folder = Files.createTempDirectory("bitstream")
    assert(Clock.ofTop("x", folder).source == "target")
    Files.writeString(folder.resolve("x.json"), """{"clockMHz": {"min": 41.5}}""")
    assert(Clock.ofTop("x", folder) == Clock(41.5, "placed"))
  }
}
