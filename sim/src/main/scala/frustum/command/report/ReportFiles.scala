package frustum.command.report

import frustum.contract.InputError
import frustum.files.InputFile
import java.nio.file.{Files, Path}
import scala.jdk.CollectionConverters._
import scala.util.Using
import scala.util.control.NonFatal

/** What a command left in its folder. */
final class ReportFiles(val folder: Path, command: String) {

  /** Files of one kind, by name; none where the folder is missing. */
  def ofKind(ending: String): Seq[Path] =
    if (!Files.isDirectory(folder)) Nil
    else Using.resource(Files.list(folder))(_.iterator.asScala.toSeq)
      .filter(f => Files.isRegularFile(f) && f.getFileName.toString.endsWith(ending)).sortBy(_.getFileName.toString)

  def find(name: String): Option[Path] = Option(folder.resolve(name)).filter(Files.isRegularFile(_))

  /** What is made of a JSON report; InputError where it is none of the command's. */
  def read[A](file: Path)(use: ujson.Obj => A): A = {
    val remedy = s"run ./sbt \"$command\" again, or remove the file"
    try ujson.read(InputFile.text(file, remedy)) match {
        case report: ujson.Obj => use(report)
        case _                 => throw new IllegalArgumentException("it is no object")
      }
    catch {
      case e: InputError => throw e
      case NonFatal(e)   =>
        throw InputError(
          s"$file: is no report of $command (${e.getMessage.linesIterator.nextOption().mkString}); $remedy"
        )
    }
  }
}
