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
}
