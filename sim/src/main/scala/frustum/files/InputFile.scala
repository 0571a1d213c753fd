package frustum.files

import frustum.contract.InputError
import java.nio.charset.{CharacterCodingException, Charset, StandardCharsets}
import java.nio.file.{Files, NoSuchFileException, Path}
import scala.util.control.NonFatal

/** Files that a person names. */
object InputFile {

  /** The text of a file, or an error that says what is wrong with it.
    *
    * @param remedy
    *   what to do about a file that is no text or cannot be read
    */
  def text(file: Path, remedy: String, charset: Charset = StandardCharsets.UTF_8): String =
    read(file, remedy)(Files.readString(_, charset))

  /** The bytes of a file, likewise. */
  def bytes(file: Path, remedy: String): Array[Byte] = read(file, remedy)(Files.readAllBytes)

  private def read[A](file: Path, remedy: String)(how: Path => A): A =
    try how(file)
    catch {
      case _: NoSuchFileException      => throw InputError(s"$file: there is no such file; check the name")
      case _: CharacterCodingException => throw InputError(s"$file: is not a text file; $remedy")
      case NonFatal(e) => throw InputError(s"$file: cannot be read (${e.getClass.getSimpleName}); $remedy")
    }
}
