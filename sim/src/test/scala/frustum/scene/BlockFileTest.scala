package frustum.scene

import frustum.contract.InputError
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files

/** Tables of blocks as JSON: errors name the line. */
class BlockFileTest extends AnyFunSuite {
  private val file = Files.createTempFile("blocks", ".json")
  private def read(text: String) = { Files.writeString(file, text); BlockFile.read(file) }

  test("a byte order mark, a block by its one texture") {
    val assets = read("\ufeff[{\"name\": \"red\", \"texture\": \"brick\"}]")
    assert(assets.table.blocks.map(_.name) == Seq("red") && assets.textures.indices.length == 1)
  }

  private val stone = """{"name": "a", "texture": "stone"}"""
  for (
    (text, words) <- Seq(
      "[]" -> Seq(":1: ", "no blocks"),
      "\n{\"name\": \"a\"}" -> Seq(":2: ", "list"),
      s"[$stone,\n 5]" -> Seq(":2: ", "block 2", "no object"),
      s"[$stone,\n {\"name\": \"b\",\n  \"txture\": \"stone\"}]" -> Seq(":3: ", "block 2", "txture"),
      s"[$stone,\n {\"name\": \"b\",\n  \"texture\": \"velvet\"}]" -> Seq(":3: ", "block 2", "velvet"),
      s"[$stone,\n {\"name\": \"b\",\n  \"texture\": \"none.png\"}]" -> Seq(":3: ", "block 2", "none.png"),
      s"[$stone,\n {\"texture\":\n \"sand\"}]" -> Seq(":2: ", "block 2", "no name"),
      s"[$stone,\n {\"name\": \"b\", \"top\": \"sand\"}]" -> Seq(":2: ", "block 2", "side"),
      s"[$stone,\n {\"name\": \"b\",\n \"opaque\": 1, \"texture\": \"sand\"}]" -> Seq(":3: ", "block 2", "opaque"),
      s"[$stone,\n {\"name\": \"b\", \"texture\": \"sand\",\n \"name\": \"c\"}]" -> Seq(
        ":3: ",
        "'name' comes twice",
        "line 2"
      ),
      s"[$stone,\n {\"name\": \"b\", \"texture\": \"glass\"}]" -> Seq(":2: ", "block 2", "opaque", "glass"),
      Seq.fill(33)(stone).mkString("[", ",\n", "]") -> Seq(":32: ", "31")
    )
  ) test(s"refused: ${text.take(70).replaceAll("\\s+", " ")}") {
    val message = intercept[InputError](read(text)).message
    assert(message.startsWith(file.toString) && !message.contains('\n'), message)
    words.foreach(w => assert(message.contains(w), message))
  }
}
