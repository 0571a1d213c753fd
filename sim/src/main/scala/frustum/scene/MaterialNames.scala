package frustum.scene

import frustum.contract.InputError
import frustum.files.Notices
import scala.collection.mutable

/** The materials that the libraries of an OBJ file hold, by name. What is missing gets a notice and no material. */
final class MaterialNames(notices: Notices) {
  private val materials = mutable.LinkedHashMap.empty[String, MtlMaterial]
  private val asked = mutable.HashMap.empty[String, Option[MtlMaterial]]

  /** Reads what a statement `mtllib` names: one file or several, the first that has a material gives it. A library
    * takes the place of those of earlier statements.
    */
  def library(line: SourceLine): Unit = {
    if (line.text.isEmpty) notices.at(line.place, "'mtllib' without a file is skipped; write 'mtllib FILE.mtl'")
    val files = MaterialNames.files(line).flatMap { name =>
      val found = NamedFile.find(line, name)
      if (found.isEmpty)
        notices.at(
          line.place,
          s"there is no file '$name', so its materials are white; put it beside ${line.file.getFileName}"
        )
      found.filterNot(_.asWritten).foreach(f =>
        notices.at(line.place, s"there is no file '$name'; ${f.path} is taken for it")
      )
      found
    }
    // an OBJ file may name its library again before each group
    val read = files.map(_.path).distinct.map { path =>
      val these =
        try MtlFile.read(path, notices)
        catch { case InputError(message) => line.error(message) }
      these.map(m => m.name -> m).toMap
    }
    materials ++= read.reverse.flatten
  }

  /** The material that a statement `usemtl` names. */
  def named(line: SourceLine): Option[MtlMaterial] = asked.getOrElseUpdate(line.text, look(line))

  private def look(line: SourceLine): Option[MtlMaterial] = {
    def plain(name: String) = NamedFile.unquoted(NamedFile.withoutComment(name))
    val found =
      materials.get(line.text).orElse(materials.collectFirst { case (name, m) if plain(name) == plain(line.text) => m })
    if (found.isEmpty) {
      val known = if (materials.isEmpty) "there are none" else s"there are: ${materials.keys.take(8).mkString(", ")}"
      val remedy = if (materials.isEmpty) "name a library by 'mtllib FILE.mtl'" else "correct the name"
      val what =
        if (line.text.isEmpty) "'usemtl' without a name" else s"material '${line.text}' is in no mtllib ($known)"
      notices.at(line.place, s"$what: its faces are white; $remedy")
    }
    found
  }
}

object MaterialNames {

  /** The names in a statement: the whole of it where that is a file; else what is in quotes, or each up to ".mtl". */
  private def files(line: SourceLine): Seq[String] =
    if (NamedFile.find(line, line.text).exists(_.asWritten)) Seq(line.text)
    else {
      val each = "\"([^\"]+)\"|(?i)(\\S.*?\\.mtl)(?=\\s|$)|(\\S+)".r.findAllMatchIn(NamedFile.withoutComment(line.text))
      each.map(m => (1 to 3).map(m.group).find(_ != null).get).toSeq
    }
}
