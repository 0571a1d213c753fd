package frustum.files

import frustum.contract.InputError
import java.io.IOException
import java.nio.file.{Files, Path, StandardCopyOption}

/** Output files are written beside their place and moved there when complete, so that none is ever half
  * written.
  */
object OutputFile {

  /** InputError where a file cannot be written: better now than after minutes of work. */
  def check(files: Path*): Unit = files.foreach(file => Files.delete(part(file)))

  /** A folder for files of programs of others, made where it is missing; InputError where that, or a file in it,
    * cannot be.
    */
  def folder(folder: Path): Path = {
    check(folder.resolve("file"))
    folder
  }

  private def part(file: Path): Path = {
    val folder = file.toAbsolutePath.getParent
    try {
      if (Files.isDirectory(file)) throw InputError(s"$file is a directory: name a file")
      Files.createDirectories(folder)
      Files.createTempFile(folder, s".${file.getFileName}", ".part")
    } catch {
      case e: IOException =>
        throw InputError(s"$file cannot be written (${reason(e)}): name a file in a writable folder")
    }
  }

  /** @param body writes the file it is given; its result is that of the whole */
  def write[A](file: Path)(body: Path => A): A = {
    val part = this.part(file)
    try {
      val result = body(part)
      part.toFile.setReadable(true, false)
      Files.move(part, file.toAbsolutePath, StandardCopyOption.REPLACE_EXISTING)
      result
    } finally Files.deleteIfExists(part)
  }

  def writeText(file: Path, text: String): Unit = write(file)(part => Files.writeString(part, text))

  private def reason(e: IOException) = s"${e.getClass.getSimpleName}: ${e.getMessage}".replace('\n', ' ')
}
