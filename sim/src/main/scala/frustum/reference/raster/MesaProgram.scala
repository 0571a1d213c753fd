package frustum.reference.raster

import frustum.files.OutputFile
import java.nio.file.{Files, Path, StandardCopyOption}
import scala.sys.process.{ProcessLogger, stringSeqToProcess}

/** A C program of the resources that draws off-screen with Mesa's llvmpipe; it says the renderer's name on stderr. */
final class MesaProgram(program: Path) {

  /** What it writes for an input; by files, because pipes of scala.sys.process lose the last kilobyte at times. */
  def run(input: String): Array[Byte] = {
    val files = Seq("in", "out", "err").map(Files.createTempFile("mesa", _))
    val Seq(from, to, errors) = files
    try {
      Files.writeString(from, input)
      val builder = new ProcessBuilder(program.toString)
      builder.environment.put("GALLIUM_DRIVER", "llvmpipe")
      val code =
        builder.redirectInput(from.toFile).redirectOutput(to.toFile).redirectError(errors.toFile).start().waitFor()
      val about = Files.readString(errors)
      if (code != 0 || !about.contains("llvmpipe"))
        throw new IllegalStateException(s"Mesa ended with $code and said: $about")
      Files.readAllBytes(to)
    } finally files.foreach(Files.delete)
  }
}

object MesaProgram {

  /** `name`.c of the resources, compiled; None where Mesa or a C compiler is missing. The program takes its place
    * whole, so that a command that runs it at the same time never meets half of one.
    */
  def compiled(name: String): Option[MesaProgram] = {
    val folder = Files.createDirectories(Path.of(".cache", "mesa")).toAbsolutePath
    val source = getClass.getResourceAsStream(s"/mesa/$name.c").readAllBytes()
    OutputFile.write(folder.resolve(s"$name.c"))(part => Files.write(part, source))
    val part = Files.createTempFile(folder, name, ".part")
    try {
      val command = Seq("gcc", "-O1", "-o", part.toString, s"$folder/$name.c", "-lOSMesa", "-lm")
      val built =
        try command.!(ProcessLogger(_ => ())) == 0
        catch { case _: java.io.IOException => false }
      Option.when(built) {
        val program = folder.resolve(name)
        Files.move(part, program, StandardCopyOption.ATOMIC_MOVE)
        new MesaProgram(program)
      }
    } finally Files.deleteIfExists(part)
  }
}
