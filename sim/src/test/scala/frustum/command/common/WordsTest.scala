package frustum.command.common

import frustum.contract.InputError
import org.scalatest.funsuite.AnyFunSuite

class WordsTest extends AnyFunSuite {
  test("blanks, quotes and backslashes") {
    for (
      (line, words) <- Seq(
        "" -> Seq(),
        "  a   b " -> Seq("a", "b"),
        "--obj 'my mesh.obj'" -> Seq("--obj", "my mesh.obj"),
        """a"b c"d""" -> Seq("ab cd"),
        """a\ b '\' "\"" """ -> Seq("a b", "\\", "\""),
        "x '' y" -> Seq("x", "", "y")
      )
    ) assert(Words.split(line) == words, line)
  }

  test("a quote that stays open is refused") {
    assert(intercept[InputError](Words.split("render --obj 'a b")).message.contains("not closed"))
  }
}
