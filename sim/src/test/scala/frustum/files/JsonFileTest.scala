package frustum.files

import frustum.contract.InputError
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files

/** JSON of a person's: what ends in an error names the line. */
class JsonFileTest extends AnyFunSuite {
  private val file = Files.createTempFile("person", ".json")
  private def read(text: String): JsonDocument = { Files.writeString(file, text); JsonFile.read(file, "docs/x.md") }
  private def refused(text: String): String = intercept[InputError](read(text)).message

  test("values are those of the library") {
    val escaped = "\"x\\u00e9\\n\""
    val text = s"""{"a": [1, 2.5e3, -7, $escaped, true, false, null, {}, []], "b": {"c": {"d": [[1], [2]]}}}"""
    assert(read(text).root == ujson.read(text))
  }

  test("a byte order mark is skipped") {
    assert(read("\ufeff[1]").root == ujson.Arr(1))
    assert(refused("\ufeff\n[1,]").startsWith(s"$file:2: "))
  }

  test("a key that comes twice is refused with both lines") {
    val message = refused("{\"a\": 1,\n \"b\": {\"c\": 1,\n  \"d\": 2,\n  \"c\": 3}}")
    assert(message == s"$file:4: the key 'c' comes twice, first in line 2; leave one of them out")
    assert(refused("{\"a\": 1, \"\\u0061\": 2}").contains("'a' comes twice"))
    assert(read("[{\"a\": 1}, {\"a\": 1}]").root.arr.length == 2)
  }

  test("lines of parts, by their paths") {
    val d = read("{\n\"a\": [1,\n 2,\n {\"b\": 3,\r\n  \"c\":\n   [\n4]}],\r\"e\": 5}")
    assert(Seq("", "a", "a[0]", "a[1]", "a[2]", "a[2].b", "a[2].c", "a[2].c[0]", "e").map(d.lineOf) == Seq(
      1, 2, 2, 3, 4, 4, 5, 7, 8
    ))
    // What is not there is looked for around it.
    assert(d.lineOf("a[2].x") == 4 && d.lineOf("a[2].c[7].y") == 5 && d.lineOf("none") == 1)
  }

  for (
    (text, words) <- Seq(
      "{\n\n\"a\": nul}" -> Seq(":3: ", "JSON", "docs/x.md"),
      "{\"a\": 1\n" -> Seq(":2: ", "too early"),
      "" -> Seq(":1: "),
      "[1]\n[2]" -> Seq(":2: "),
      "\n" + "[" * 100000 -> Seq(":2: ", "deeper than 64"),
      "{\"a\":" * 100000 -> Seq(":1: ", "deeper than 64")
    )
  ) test(s"refused: ${text.take(20).replaceAll("\\s", " ")}") {
    val message = refused(text)
    assert(message.startsWith(file.toString) && !message.contains('\n'), message)
    words.foreach(w => assert(message.contains(w), message))
  }
}
