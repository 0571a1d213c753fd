package frustum.command.common

import frustum.boards.Tops
import frustum.BuildInfo
import frustum.files.InfinityAsNull
import java.nio.file.{Files, Path, Paths}
import scala.util.Try

/** The clock that frame rates are reckoned with, and where it comes from: "placed" or "target". */
final case class Clock(mhz: Double, source: String)

object Clock {
  private val TargetMHz = 36.0

  /** The slowest seed of the top's last bitstream report where there is one, else the frequency it aims
    * at.
    */
  def ofTop(top: String, folder: Path = Paths.get("out", "bitstream")): Clock = {
    val report = folder.resolve(s"$top.json")
    val placed = Option.when(Files.isRegularFile(report))(report)
      .flatMap(r => Try(ujson.read(Files.readString(r))("clockMHz")("min").num).toOption)
    placed.fold(Clock(Tops.find(top).fold(TargetMHz)(_.targetMHz.toDouble), "target"))(Clock(_, "placed"))
  }
}
