package frustum.command.verilog

import frustum.command.common.{CommandLine, TopArguments}
import frustum.files.OutputFile
import java.nio.file.{Files, Path, Paths, StandardCopyOption}

/** `verilog TOP`: the Verilog of a board's top, in one file `out/verilog/TOP.v`. */
object VerilogCommand extends CommandLine {
  val name = "verilog"
  val summary = "writes the Verilog of a board's top to out/verilog/TOP.v"

  private val parser = TopArguments.parser(name, summary, seeds = false)

  def run(args: Seq[String]): Int = {
    TopArguments.parse(parser, args).foreach { arguments =>
      val top = arguments.find
      val directory = Paths.get("out", "verilog")
      val file: Path = directory.resolve(s"${top.name}.v")
      OutputFile.check(file)
      val scratch = Files.createTempDirectory(directory, ".elaborate")
      try {
        top.writeVerilog(scratch.toString)
        Files.move(scratch.resolve(s"${top.name}.v"), file, StandardCopyOption.REPLACE_EXISTING)
        println(s"wrote $file")
      } finally {
        scratch.toFile.listFiles.foreach(_.delete())
        Files.delete(scratch)
      }
    }
    0
  }
}
