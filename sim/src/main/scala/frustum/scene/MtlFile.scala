package frustum.scene

import frustum.contract.InputError
import frustum.files.Notices
import java.nio.file.Path

/** A material as its library has it.
  *
  * @param line     its `newmtl`
  * @param color    red, green, blue, 0..1
  * @param opacity  by `d`, 0..1
  * @param clear    by `Tr`, 0..1: 1 - opacity
  * @param map      picture of the colour (`map_Kd`)
  * @param alphaMap picture of the opacity (`map_d`)
  */
final case class MtlMaterial(
    name: String,
    line: SourceLine,
    color: (Double, Double, Double) = (1, 1, 1),
    opacity: Option[Double] = None,
    clear: Option[Double] = None,
    map: Option[MapStatement] = None,
    alphaMap: Option[MapStatement] = None
) {

  /** `d` counts where both are there: tools that write both mean different things by `Tr`. What eight bits cannot tell
    * from opaque is opaque.
    */
  def alpha: Double = {
    val a = opacity.orElse(clear.map(1 - _)).getOrElse(1.0)
    if (a > 1 - MtlFile.HalfLevel) 1 else a
  }
}

/** Material libraries (MTL): diffuse colour, opacity and their pictures; what the hardware has no use for is skipped.
  * What is malformed concerns looks alone: it is skipped with a notice.
  */
object MtlFile {

  /** Half a level of eight bits: whoever writes 1.000001 means 1, and gets it without a notice. */
  val HalfLevel: Double = 0.5 / 255

  /** Materials in the file's order. InputError where the file cannot be read. */
  def read(file: Path, notices: Notices): IndexedSeq[MtlMaterial] =
    SourceLine.read(file).foldLeft(Vector.empty[MtlMaterial]) { (before, line) =>
      try statement(before, line, notices)
      catch {
        case InputError(message) =>
          notices.at(line.place, s"${message.stripPrefix(s"${line.place}: ")}; skipped", s"${line.place} skipped")
          before
      }
    }

  private def statement(
      before: Vector[MtlMaterial],
      line: SourceLine,
      notices: Notices
  ): Vector[MtlMaterial] = {
    def change(f: MtlMaterial => MtlMaterial) = before match {
      case others :+ last => others :+ f(last)
      case _              => line.error(s"'${line.name}' before any 'newmtl'; start the material with 'newmtl NAME'")
    }
    line.keyword match {
      case "newmtl" =>
        if (line.text.isEmpty) notices.at(line.place, "a material without a name; write 'newmtl NAME'")
        before :+ MtlMaterial(line.text, line)
      case "kd"               => change(_.copy(color = diffuse(line, notices)))
      case "d"                => change(_.copy(opacity = Some(fraction(line, notices))))
      case "tr"               => change(_.copy(clear = Some(fraction(line, notices))))
      case "map_kd" | "map_d" =>
        val map = picture(line, notices)
        change(m => if (line.keyword == "map_kd") m.copy(map = Some(map)) else m.copy(alphaMap = Some(map)))
      case _ => before
    }
  }

  private def picture(line: SourceLine, notices: Notices): MapStatement = {
    val map = MapStatement(line)
    if (map.name.isEmpty)
      line.error(s"'${s"${line.name} ${line.text}".trim}' without a file; write '${line.name} FILE.png'")
    val channel = map.channel.filter(_ => line.keyword == "map_kd").map(_ => "-imfchan")
    val options = (map.skipped ++ channel).distinct.map(o => s"'$o'").mkString(", ")
    if (options.nonEmpty)
      notices.at(line.place, s"${line.name}: $options changes nothing here; skipped", s"${line.keyword} $options")
    map
  }

  private def diffuse(line: SourceLine, notices: Notices): (Double, Double, Double) = {
    if (line.words.headOption.exists(w => w == "spectral" || w == "xyz"))
      line.error(s"'Kd ${line.words.head}' is not supported; write 'Kd R G B'")
    val c = line.numbers(1, 3, "R G B, each 0..1").map(within(line, _, "write 'Kd R G B', each 0..1", notices))
    if (c.length == 3) (c(0), c(1), c(2)) else (c(0), c(0), c(0))
  }

  /** `d` may have an option of its own: more transparent towards the middle, which is not drawn here. */
  private def fraction(line: SourceLine, notices: Notices): Double = {
    val halo = line.words.headOption.exists(_.equalsIgnoreCase("-halo"))
    val plain = if (halo) line.copy(text = line.words.drop(1).mkString(" ")) else line
    if (halo) notices.at(line.place, "d: '-halo' changes nothing here; skipped", "d -halo")
    within(line, plain.numbers(1, 1, "A, 0..1").head, s"write '${line.name} A' with A in 0..1", notices)
  }

  private def within(line: SourceLine, value: Double, remedy: String, notices: Notices): Double = {
    if (value < -HalfLevel || value > 1 + HalfLevel)
      notices.at(
        line.place,
        s"'${line.name} ${line.text}' is outside 0..1 and clamped; $remedy",
        s"${line.keyword} clamped"
      )
    value.max(0).min(1)
  }
}
