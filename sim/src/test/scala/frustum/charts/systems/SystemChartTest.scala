package frustum.charts.systems

import frustum.charts.plot.ParetoFront
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files
import javax.imageio.ImageIO

class SystemChartTest extends AnyFunSuite {
  private def point(
      setting: String,
      speed: Double,
      error: Double,
      placed: Boolean,
      cells: Option[Int],
      built: Boolean = true
  ) =
    SystemPoint("group", setting, speed, 36, placed, built, cells, Seq(Some(error)))
  private def chart(points: Seq[SystemPoint], peers: Seq[PeerPoint] = Nil) =
    SystemChart(
      "name",
      "cube: frames a second against error",
      "frames a second",
      Seq("error, %"),
      points,
      peers,
      "Note.",
      cellsTitle = Some("cube: logic cells against error")
    )

  private val slow = point("slow", 100, 1, placed = true, Some(4000))
  private val worse = point("worse", 90, 1, placed = true, Some(3000))
  private val fast = point("fast", 200, 5, placed = true, Some(5000))
  private val aimed = point("aimed", 900, 0, placed = false, None)
  private val method = point("method", 999, 0, placed = true, None, built = false)

  test("the front: more speed, less error; equal ones are all kept") {
    val costs = Seq((1, 9), (2, 5), (3, 5), (4, 1), (4, 1), (5, 2))
    assert(ParetoFront(costs)(_._1.toDouble, _._2.toDouble) == Seq((1, 9), (2, 5), (4, 1), (4, 1)))
    assert(ParetoFront(Seq.empty[Int])(_.toDouble, _.toDouble).isEmpty)
  }

  test("a clock that is only aimed at beats no placed one, and a method without hardware nothing") {
    val c = chart(Seq(slow, worse, fast, aimed, method))
    assert(c.front(0).toSet == Set(slow, fast))
    assert(c.cellsFront(0).toSet == Set(worse))
    assert(chart(Seq(aimed, aimed.copy(setting = "less", speed = 800), method)).front(0) == Seq(aimed))
  }

  test("points without a placed clock are hollow, and the picture says which clock they have") {
    val c = chart(Seq(slow, aimed))
    val panel = c.speedPlot.panels.head
    assert(panel.points.map(_.hollow) == Seq(false, true) && panel.points.map(_.label) == Seq("1", "2"))
    val words = c.speedPlot.legend.map(_.text).mkString(" ")
    assert(words.contains("no placed clock is known") && words.contains("36 MHz"), words)
    assert(chart(Seq(aimed)).cellsPlot.isEmpty && c.cellsPlot.get.panels.head.points.length == 1)
  }

  test("the area of a point is in proportion to its logic cells") {
    val Seq(a, b) = chart(Seq(slow, worse)).speedPlot.panels.head.points.map(_.radius)
    assert((a * a / (b * b) - 4000.0 / 3000).abs < 1e-9)
  }

  test("a peer of which only the speed is known is marked from end to end") {
    val peer = PeerPoint("Rasterix", Some((80.6, 97.9)), None, Seq(None))
    val range = chart(Seq(slow), Seq(peer)).speedPlot.panels.head.ranges
    assert(range.map(r => (r.name, r.x, r.y)) == Seq(("Rasterix", Some((80.6, 97.9)), None)))
  }

  test("the CSV has a row a system and quotes what holds a comma; the JSON has the same figures") {
    val lines = chart(Seq(slow, aimed.copy(setting = "a, b"))).csv.linesIterator.toSeq
    assert(lines.head == "group,setting,frames a second,\"error, %\",clockMHz,clockSource,logicCells,built,front")
    assert(lines(1) == "group,slow,100.0,1.0,36.0,placed,4000,true,1")
    assert(lines(2) == "group,\"a, b\",900.0,0.0,36.0,target,,true,")
    val points = chart(Seq(slow, aimed)).json("points")
    assert(points(0)("logicCells").num == 4000 && points(1)("clockSource").str == "target")
  }

  test("pictures are 960 pixels wide, and as SVG they hold the words of the legend") {
    val out = Files.createTempDirectory("systems")
    chart(Seq(slow, fast)).write(out)
    assert(out.toFile.list().toSet ==
      Set("name.csv", "name.png", "name.svg", "name-cells.png", "name-cells.svg"))
    assert(ImageIO.read(out.resolve("name.png").toFile).getWidth == 960)
    val svg = Files.readString(out.resolve("name.svg"))
    assert(svg.contains("frames a second") && svg.contains("[1] slow"))
    chart(Seq(slow, fast)).write(out)
    assert(Files.readString(out.resolve("name.svg")) == svg, "the same chart is another file")
  }
}
