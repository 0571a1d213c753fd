package frustum.scene

import frustum.contract.raster.Combine
import frustum.driver.scene.{Material, TextureImage}
import java.nio.file.Path

/** A material library (MTL): diffuse colour, opacity and picture; what the hardware has no use for is
  * skipped.
  */
object MtlFile {

  /** Diffuse colour 0..1, opacity 0..1 and picture of a material. */
  private final case class Entry(
      name: String,
      color: (Double, Double, Double) = (1, 1, 1),
      alpha: Double = 1,
      texture: Option[TextureImage] = None
  )

  /** Materials by name; InputError naming file and line.
    *
    * @param namedBy
    *   the statement of the OBJ file that names the library
    */
  def read(file: Path, namedBy: SourceLine): Map[String, Material] =
    SourceLine
      .read(file, Some(namedBy))
      .foldLeft(Vector.empty[Entry]) { (entries, line) =>
        def change(f: Entry => Entry) = entries match {
          case before :+ last => before :+ f(last)
          case _              =>
            line.error(s"'${line.keyword}' before any 'newmtl'; start the material with 'newmtl NAME'")
        }
        line.keyword match {
          case "newmtl" =>
            if (line.text.isEmpty) line.error("a material without a name; write 'newmtl NAME'")
            entries :+ Entry(line.text)
          case "Kd"     => change(_.copy(color = diffuse(line)))
          case "d"      => change(_.copy(alpha = fraction(line)))
          case "Tr"     => change(_.copy(alpha = 1 - fraction(line)))
          case "map_Kd" => change(_.copy(texture = Some(picture(line))))
          case _        => entries
        }
      }
      .map(e => e.name -> material(e))
      .toMap

  private def material(e: Entry): Material = e.texture match {
    case Some(picture) => Material.textured(e.name, picture, e.alpha)
    case None          => Material(e.name, e.color, e.alpha, None, Combine.ColorOnly, blend = e.alpha < 1, None)
  }

  private def diffuse(line: SourceLine): (Double, Double, Double) = {
    if (line.words.headOption.exists(w => w == "spectral" || w == "xyz"))
      line.error(s"'Kd ${line.words.head}' is not supported; write 'Kd R G B'")
    val c = line.numbers(1, 3, "R G B, each 0..1")
    if (c.exists(v => v < 0 || v > 1))
      line.error(s"'Kd ${line.text}' is outside 0..1; write 'Kd R G B', each 0..1")
    if (c.length == 3) (c(0), c(1), c(2)) else (c(0), c(0), c(0))
  }

  private def fraction(line: SourceLine): Double = {
    val v = line.numbers(1, 1, "A, 0..1").head
    if (v < 0 || v > 1)
      line.error(s"'${line.keyword} $v' is outside 0..1; write '${line.keyword} A' with A in 0..1")
    v
  }

  private def picture(line: SourceLine): TextureImage = {
    if (line.text.isEmpty) line.error("'map_Kd' without a file; write 'map_Kd FILE.png'")
    if (line.text.startsWith("-"))
      line.error(
        s"map_Kd option '${line.words.head}' is not supported; change the picture instead " +
          "and write 'map_Kd FILE.png'"
      )
    TextureFile.read(beside(line), Some(line))
  }

  /** File names are relative to the file that names them; some exporters write backslashes. */
  private[scene] def beside(line: SourceLine): Path =
    try line.file.resolveSibling(line.text.replace('\\', '/'))
    catch {
      case _: java.nio.file.InvalidPathException =>
        line.error(s"'${line.text}' is not a file name; rename the file")
    }
}
