package frustum.play

import frustum.contract.InputError
import frustum.model.demos.pong.PongButtons
import org.scalatest.funsuite.AnyFunSuite

import java.nio.file.Files

class ButtonFileTest extends AnyFunSuite {
  private val file = Files.createTempFile("buttons", ".txt")
  private def read(content: String) = { Files.writeString(file, content); ButtonFile.read(file) }

  test("a line a tick") {
    val all = read("u\n-\nd l\nudlr\n r \n")
    assert(all == Seq(
      PongButtons(up = true),
      PongButtons(),
      PongButtons(down = true, left = true),
      PongButtons(up = true, down = true, left = true, right = true),
      PongButtons(right = true)
    ))
    assert(read("").isEmpty)
  }

  for (
    (content, place, word) <-
      Seq(("u\n-\nx\n", 3, "'x'"), ("u-\n", 1, "'-'"), ("u\n\nd\n", 2, "empty"), ("U", 1, "'U'"))
  )
    test(s"refused with file and line: ${content.replace("\n", "\\n")}") {
      val e = intercept[InputError](read(content))
      assert(e.message.startsWith(s"$file:$place: ") && e.message.contains(word), e.message)
    }

  test("no file, no text") {
    assert(intercept[InputError](
      ButtonFile.read(file.resolveSibling("none-such"))
    ).message.contains("no such file"))
    Files.write(file, Array[Byte](-1, -2, 0, 1))
    assert(intercept[InputError](ButtonFile.read(file)).message.contains("not a text file"))
  }
}
