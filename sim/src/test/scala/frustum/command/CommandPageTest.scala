package frustum.command

import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.{Files, Paths}

class CommandPageTest extends AnyFunSuite {
  test("docs/commands.md is what the command table prints") {
    assert(
      Files.readString(Paths.get(CommandPage.file)) == CommandPage.text,
      s"${CommandPage.file} is stale: write it anew with ./sbt \"sim/runMain frustum.command.CommandPage\""
    )
  }

  test("paragraphs and items are wrapped, code spans, tables and headings are not") {
    val span = "`" + "a b " * 40 + "`"
    assert(WrappedText("x " * 100) == ("x " * 54 + "x") + "\n" + ("x " * 44 + "x"))
    assert(WrappedText("- " + "word " * 40).linesIterator.toSeq.tail.forall(_.startsWith("  word")))
    assert(WrappedText(s"say $span now") == s"say\n$span\nnow")
    for (whole <- Seq("| " + "cell " * 40, "# " + "head " * 40, "```\n" + "code " * 40 + "\n```"))
      assert(WrappedText(whole) == whole)
    assert(CommandPage.text.linesIterator.filterNot(l => l.startsWith("|") || l.startsWith("0x")).forall(
      _.length <= WrappedText.Columns
    ))
  }
}
