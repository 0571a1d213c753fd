package frustum.files

import frustum.contract.InputError
import java.nio.file.Path
import scala.util.control.NonFatal

/** JSON files that a person writes. */
object JsonFile {

  /** What is in a file, or an error that names the line.
    *
    * @param page of the documentation that tells the form
    */
  def read(file: Path, page: String): ujson.Value = {
    val text = InputFile.text(file, "give a JSON file in UTF-8")
    try ujson.read(text)
    catch {
      case e: ujson.ParseException =>
        throw InputError(s"$file:${line(text, e.index)}: is not JSON: ${e.clue}; see $page for the form")
      case NonFatal(_) =>
        throw InputError(s"$file:${line(text, text.length)}: is not JSON: it ends too early")
    }
  }

  private def line(text: String, index: Int) = text.take(index).count(_ == '\n') + 1
}
