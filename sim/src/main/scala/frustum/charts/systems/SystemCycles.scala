package frustum.charts.systems

import frustum.driver.raster.{Driver, PreparedFrame}
import frustum.engine.raster.{EngineOptions, RasterEngines}
import frustum.files.{Digest, OutputFile}
import java.nio.file.{Files, Path}

/** Core cycles of frames, by simulation of the Stream core: store loaded, sink always ready. Kept by the digests of the
  * hardware's Verilog and of the commands.
  *
  * @param simulate None: what is not known stays unknown
  */
final class SystemCycles(simulate: PreparedFrame => Long, cache: Path = PlacedTops.Cache) {

  /** @param verilog digest of the hardware
    * @param may     whether it may be simulated where it is not known
    */
  def apply(frame: PreparedFrame, verilog: String, may: Boolean): Option[Long] = {
    val file = cache.resolve(s"cycles-${SystemCycles.digest(frame, verilog)}.json")
    if (Files.isRegularFile(file)) Some(ujson.read(Files.readString(file))("cycles").num.toLong)
    else
      Option.when(may) {
        val cycles = simulate(frame)
        OutputFile.writeText(file, ujson.write(ujson.Obj("cycles" -> cycles.toDouble)) + "\n")
        cycles
      }
  }
}

object SystemCycles {
  def simulation(frame: PreparedFrame): Long =
    RasterEngines.byName("pipeline").make(EngineOptions(1, None)).drawAll(Seq(frame)).head.clocks.get

  private def digest(frame: PreparedFrame, verilog: String): String =
    Digest(verilog.getBytes("UTF-8"), frame.passes.flatMap(Driver.commands).flatten.map(_.toByte).toArray)
}
