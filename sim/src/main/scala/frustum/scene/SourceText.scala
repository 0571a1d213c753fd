package frustum.scene

import frustum.contract.InputError
import frustum.files.InputFile
import java.nio.ByteBuffer
import java.nio.charset.{CharacterCodingException, Charset, StandardCharsets}
import java.nio.file.Path

/** The lines of a text file as tools of all times write it: UTF-8; UTF-16 where a byte order mark says so; otherwise
  * Windows' Western code page. Lines end in LF, CR LF or CR; DOS' end-of-file character ends the text.
  */
object SourceText {
  private val Windows = Charset.forName("windows-1252")
  private val DosEndOfFile = '\u001a'

  /** InputError naming the file where it cannot be read or is no text. */
  def lines(file: Path): IndexedSeq[String] = {
    val text = decode(InputFile.bytes(file, "give a readable text file"))
    if (text.contains('\u0000')) throw InputError(s"$file: is not a text file; give an OBJ or MTL file in text form")
    text.takeWhile(_ != DosEndOfFile).split("\r\n|\r|\n", -1).toIndexedSeq
  }

  private def decode(bytes: Array[Byte]): String = {
    def starts(mark: Int*) = bytes.take(mark.length).map(_ & 255).sameElements(mark)
    if (starts(0xff, 0xfe) || starts(0xfe, 0xff)) new String(bytes, StandardCharsets.UTF_16)
    else
      try StandardCharsets.UTF_8.newDecoder.decode(ByteBuffer.wrap(bytes)).toString.stripPrefix("\ufeff")
      catch { case _: CharacterCodingException => new String(bytes, Windows) }
  }
}
