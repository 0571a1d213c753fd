package frustum.scene

import java.nio.file.{Files, InvalidPathException, Path}
import java.text.Normalizer
import scala.jdk.CollectionConverters._
import scala.util.{Try, Using}

/** A file that a statement names, relative to the file that has the statement.
  *
  * @param asWritten false where it is not quite what the statement says
  */
final case class NamedFile(path: Path, asWritten: Boolean)

object NamedFile {

  /** The file, None where there is none. A name is taken as it stands, then without quotes, with Windows' separators,
    * and without a comment; then in any case of letters and any composition of accents; at last without its folders,
    * which are those of the machine that wrote it.
    */
  def find(line: SourceLine, name: String): Option[NamedFile] = {
    val names = spellings(name)
    def exact =
      names.iterator.flatMap(n => beside(line, n)).find(Files.isRegularFile(_)).map(NamedFile(_, asWritten = true))
    def loose = (names.iterator ++ names.map(_.replaceFirst("^.*/", ""))).flatMap(similar(line, _)).nextOption()
      .map(NamedFile(_, asWritten = false))
    exact.orElse(loose).map(f => f.copy(path = f.path.normalize))
  }

  /** As it stands, without quotes, with separators of Unix, without a comment. */
  def spellings(name: String): Seq[String] = {
    val plain = Seq(name, unquoted(name), withoutComment(name), unquoted(withoutComment(name)))
    (plain ++ plain.map(_.replace('\\', '/'))).distinct.filter(_.nonEmpty)
  }

  def unquoted(name: String): String =
    if (name.length > 1 && Seq("\"", "'").exists(q => name.startsWith(q) && name.endsWith(q)))
      name.drop(1).dropRight(1).trim
    else name

  def withoutComment(name: String): String = name.replaceFirst("\\s+#.*", "")

  private def beside(line: SourceLine, name: String): Option[Path] =
    try Some(line.file.resolveSibling(name))
    catch { case _: InvalidPathException => None }

  /** The file whose folders and name are the same but for case and composition. */
  private def similar(line: SourceLine, name: String): Option[Path] = {
    val (root, steps) =
      if (name.startsWith("/")) (line.file.getFileSystem.getPath("/"), name.split('/').toSeq)
      else (Option(line.file.getParent).getOrElse(line.file.getFileSystem.getPath(".")), name.split('/').toSeq)
    steps.filter(_.nonEmpty).foldLeft(Option(root)) { (folder, step) =>
      folder.flatMap { f =>
        if (step == "." || step == "..") Some(f.resolve(step))
        else entries(f).find(e => key(e.getFileName.toString) == key(step))
      }
    }.filter(Files.isRegularFile(_))
  }

  private def entries(folder: Path): Seq[Path] =
    Try(Using.resource(Files.list(folder))(_.iterator.asScala.toVector.sorted)).getOrElse(Nil)

  private def key(name: String): String = Normalizer.normalize(name, Normalizer.Form.NFC).toLowerCase
}
