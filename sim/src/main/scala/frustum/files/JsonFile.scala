package frustum.files

import frustum.contract.InputError
import java.nio.file.Path
import scala.util.control.NonFatal

/** JSON files that a person writes: in UTF-8, with or without a byte order mark, each key of an object once. */
object JsonFile {

  /** What is in a file, or an error that names the line.
    *
    * @param page of the documentation that tells the form
    */
  def read(file: Path, page: String): JsonDocument = {
    val text = InputFile.text(file, "give a JSON file in UTF-8").stripPrefix(ByteOrderMark)
    def refuse(index: Int, what: String): Nothing = throw InputError(s"$file:${line(text, index)}: $what")
    val places = new JsonPlaces
    try JsonDocument(file, ujson.transform(text, places.visitor("")), path => line(text, places.of(path)))
    catch {
      case e: ujson.ParseException    => refuse(e.index, s"is not JSON: ${e.clue}; see $page for the form")
      case JsonTwice(key, index, one) =>
        refuse(index, s"the key '$key' comes twice, first in line ${line(text, one)}; leave one of them out")
      case JsonDepth(index) => refuse(index, s"is nested deeper than ${JsonPlaces.MostDepth}; see $page for the form")
      case NonFatal(_)      => refuse(text.length, "is not JSON: it ends too early")
    }
  }

  private val ByteOrderMark = "\ufeff"

  private def line(text: String, index: Int) = text.take(index).split("\r\n|\r|\n", -1).length
}

/** @param lineOf the line on which a part begins, by its path, such as `spheres[0].radius`; of a part that is not
  *   there, that of what it would be in
  */
final case class JsonDocument(file: Path, root: ujson.Value, lineOf: String => Int) {
  def refuse(path: String, what: String): Nothing = throw InputError(s"$file:${lineOf(path)}: $what")
}
