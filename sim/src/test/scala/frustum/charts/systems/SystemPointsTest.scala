package frustum.charts.systems

import frustum.boards.BoardTop
import frustum.contract.raster.PackedVertex
import frustum.contract.voxel.LeapField
import frustum.charts.LeapFamily
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files

/** Points of the charts with clocks and cycles that are made up, so that speeds can be worked out by hand. */
class SystemPointsTest extends AnyFunSuite {
  private val placed: BoardTop => (Option[Placed], String) =
    _ => (Some(Placed(Some(4000), Some(40.0), "test")), "digest")
  private val unknown: BoardTop => (Option[Placed], String) = _ => (None, "digest")

  private def chart(tops: BoardTop => (Option[Placed], String), simulatesAll: Boolean): SystemChart = {
    val empty = Files.createTempDirectory("systems")
    val cycles = new SystemCycles(_ => 80000L, empty)
    var made = Option.empty[SystemChart]
    new RasterSystems(tops, cycles, simulatesAll, _ => (), Some(PeerFigures.read()), _ => (), empty)
      .charts(Seq(Scenes.byName("cube")), c => made = Some(c))
    made.get
  }

  test("frames a second are the placed clock over the cycles; a method has the clock aimed at, 36 MHz") {
    val c = chart(placed, simulatesAll = true)
    for (p <- c.points if p.built) assert(p.speed == 500.0 && p.placed && p.cells.contains(4000), p)
    for (p <- c.points if !p.built) assert(p.speed == 450.0 && !p.placed && p.cells.isEmpty, p)
    assert(c.points.exists(!_.built) && c.points.exists(_.group == SystemConfiguration.Scene))
    val peer = c.peers.head.speed.get
    assert((peer._1 - 80.645).abs < 0.001 && (peer._2 - 97.872).abs < 0.001)
  }

  test("where nothing is placed all are hollow; what may not be simulated is left out, and counted") {
    val c = chart(unknown, simulatesAll = false)
    assert(c.points.forall(p => !p.placed && p.speed == 450.0) && c.cellsPlot.isEmpty)
    assert(!c.points.exists(_.group == SystemConfiguration.Scene) && c.note.contains("not known: 2;"), c.note)
  }

  test("coarser vertices stay where the hardware takes them, at the ends of the range too") {
    val coarser = SystemConfiguration.all(Scenes.byName("floor")).filter(_.group == SystemConfiguration.Vertices)
    assert(coarser.length == 2)
    for (c <- coarser; end <- Seq(-PackedVertex.MaxXy, PackedVertex.MaxXy)) {
      val v = c.adjust(PackedVertex(end, end, 0, 32768, 16, 0, 0, 0, 0, 0, 0))
      assert(v.fault(c.config.ranges).isEmpty && (v.x - end).abs < 16, (c.setting, v))
    }
  }

  test("rays: a pixel a cycle, exact differences without a wrong silhouette, fewer bits of light are worse") {
    val c = new RaySystems(_ => (Some(Placed(None, Some(38.2), "test")), "")).chart
    val shipped = c.points.filter(_.group.startsWith("shipped"))
    assert(shipped.map(_.speed).forall(_ == 38.2) && shipped.forall(_.errors.head.contains(0.0)))
    val light = c.points.filter(_.group == "bits of light").map(_.errors(1).get)
    assert(light == light.sorted.reverse && light.head > shipped.head.errors(1).get)
    assert(c.points.filter(_.group.startsWith("discriminant")).forall(p => !p.built && p.speed == 25.125))
  }

  test("voxels: the clock over the steps of a ray, and the world's words times their bits") {
    val c = new VoxelSystems(_ => (Some(Placed(None, Some(145.4), "test")), "")).chart
    val plain = c.points.head
    assert(plain.errors.head.contains(64 * 64 * 32 * LeapField.Plain.wordBits / 1024.0))
    assert((plain.speed - 100 / LeapFamily.steps(LeapField.Plain)).abs < 1e-9 && !plain.placed)
    val shipped = c.points.filter(_.placed)
    assert(shipped.length == 1 && shipped.head.clockMHz == 145.4 && shipped.head.errors.forall(_.isDefined))
  }
}
