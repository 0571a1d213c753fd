package frustum.command.bench

import frustum.bench.{RasterBench, RasterFigures}
import frustum.BuildInfo
import frustum.command.common.{Arguments, CommandLine}
import frustum.contract.InputError
import frustum.files.OutputFile
import scopt.OParser
import java.nio.file.Paths
import java.util.Locale

/** Arguments of `bench`. */
final case class BenchOptions(what: String = "", seed: Long = 1, positions: Int = 200)

/** `bench raster`: cycles of the rasterizer on standard loads, beside the peer's. */
object BenchCommand extends CommandLine {
  val name = "bench"
  val summary = "measures cycles of standard loads; writes out/bench/raster.json"

  private val parser: OParser[_, BenchOptions] = {
    val builder = OParser.builder[BenchOptions]
    import builder._
    OParser.sequence(
      programName("./sbt bench"),
      head(s"bench: $summary"),
      arg[String]("raster").optional().action((v, o) => o.copy(what = v)).text("what to measure: raster"),
      opt[Long]("seed")(
        Arguments.seed
      ).valueName("N").action((v, o) => o.copy(seed = v)).text("of the positions (default 1)"),
      opt[Int]("positions")(Arguments.count).valueName("N").action((v, o) => o.copy(positions = v))
        .text("random positions for each average (default 200)"),
      note("  --help                   prints this")
    )
  }

  def run(args: Seq[String]): Int = Arguments.parse(name, parser, args, BenchOptions()).fold(0) { o =>
    if (o.what != "raster") throw InputError(s"argument: there is no bench '${o.what}'; write bench raster")
    val figures = new RasterBench(o.seed, o.positions, step => println(s"bench raster: $step")).run()
    val file = Paths.get("out", "bench", "raster.json")
    OutputFile.writeText(file, ujson.write(json(o, figures), indent = 2) + "\n")
    println(table(figures))
    println(s"wrote $file")
    0
  }

  private def json(o: BenchOptions, f: RasterFigures): ujson.Obj = ujson.Obj(
    "command" -> name,
    "version" -> BuildInfo.version,
    "seed" -> o.seed.toDouble,
    "engine" -> "pipeline",
    "positions" -> o.positions,
    "fullScreenClocksPerPixel" -> f.fullScreenClocksPerPixel,
    "setupClocks" -> f.setupClocks,
    "tileRebaseClocks" -> f.tileRebaseClocks,
    "rightTriangleClocks" -> ujson.Obj.from(f.rightTriangleClocks.map { case (n, c) => n.toString -> ujson.Num(c) }),
    "randomIn16Clocks" -> f.randomIn16Clocks,
    "diagonalSliverClocks" -> f.diagonalSliverClocks,
    "needleClocksPerPixel" -> f.needleClocksPerPixel,
    "bytesPerTriangle" -> f.bytesPerTriangle,
    "cubeClocksPerFrame" -> f.cubeClocksPerFrame,
    "textureUploadClocks" -> f.textureUploadClocks,
    "clearClocksPerFrame" -> f.clearClocksPerFrame
  )

  /** What the peer takes for the same, where it is known. */
  private val peerRight = Map(1 -> 51.0, 2 -> 63.0, 4 -> 102.0, 8 -> 204.0, 16 -> 505.0, 32 -> 1466.0, 50 -> 3193.0)

  private def table(f: RasterFigures): String = {
    val rows: Seq[(String, Double, Option[Double])] = Seq(
      ("full screen, cycles a pixel", f.fullScreenClocksPerPixel, Some(2.09)),
      ("set-up of a triangle", f.setupClocks, None),
      ("moving it to a further tile", f.tileRebaseClocks, None)
    ) ++ f.rightTriangleClocks.map { case (n, c) => (s"right triangle of $n", c, peerRight.get(n)) } ++ Seq(
      ("random triangle in 16 x 16", f.randomIn16Clocks, None),
      ("diagonal sliver", f.diagonalSliverClocks, Some(4104.0)),
      ("needle, cycles a pixel", f.needleClocksPerPixel, None),
      ("bytes a triangle, closed mesh", f.bytesPerTriangle, Some(88.0)),
      ("textured cube, a frame", f.cubeClocksPerFrame, Some(282000.0)),
      ("upload of a 64 x 64 texture", f.textureUploadClocks, None),
      ("empty frame", f.clearClocksPerFrame, Some(2.0 * 240 * 320))
    )
    def number(v: Double) = (if (v < 100) "%,.2f" else "%,.0f").formatLocal(Locale.ROOT, v)
    val cells = Seq("cycles", "here", "the peer", "peer / here") +: rows.map { case (name, here, peer) =>
      Seq(name, number(here), peer.fold("-")(number), peer.fold("-")(p => "%.2f".formatLocal(Locale.ROOT, p / here)))
    }
    cells.map(r => r.head.padTo(32, ' ') + r.tail.map(c => c.reverse.padTo(12, ' ').reverse).mkString).mkString("\n")
  }
}
