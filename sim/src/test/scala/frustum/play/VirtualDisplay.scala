package frustum.play

import java.nio.file.{Files, Path, Paths}
import java.util.concurrent.TimeUnit
import scala.io.Source

/** Runs main classes of the tests on a display that is only memory (Xvfb). */
object VirtualDisplay {
  def isThere: Boolean = server && windowSystem

  /** Why a test is skipped. */
  def missing: String = if (server) "the JDK has no window system (Debian: default-jre)" else "Xvfb is not installed"

  private def server: Boolean =
    sys.env.getOrElse("PATH", "").split(':').exists(d => Files.isExecutable(Paths.get(d, "Xvfb")))

  /** A headless JDK lacks the library of the X window system. */
  private def windowSystem: Boolean =
    Files.exists(Paths.get(System.getProperty("java.home"), "lib", "libawt_xawt.so"))

  /** What the class prints; it must end by itself, well, and within `seconds`. */
  def run(mainClass: String, seconds: Int, args: String*): String = {
    val log = Files.createTempFile("xvfb", ".log")
    val server =
      new ProcessBuilder("Xvfb", "-displayfd", "1", "-screen", "0", "1024x768x24", "-nolisten", "tcp")
        .redirectError(log.toFile).start()
    try {
      val display = Source.fromInputStream(server.getInputStream).getLines().next().trim
      java(mainClass, s":$display", seconds, args)
    } finally {
      server.destroy()
      server.waitFor(10, TimeUnit.SECONDS)
      Files.delete(log)
    }
  }

  private def java(mainClass: String, display: String, seconds: Int, args: Seq[String]): String = {
    val out: Path = Files.createTempFile("display", ".txt")
    val command = Seq(
      Paths.get(System.getProperty("java.home"), "bin", "java").toString,
      "-cp",
      System.getProperty("java.class.path"),
      mainClass
    ) ++ args
    val builder = new ProcessBuilder(command: _*).redirectErrorStream(true).redirectOutput(out.toFile)
    builder.environment.put("DISPLAY", display)
    val process = builder.start()
    try {
      val ended = process.waitFor(seconds.toLong, TimeUnit.SECONDS)
      val said = Files.readString(out)
      assert(ended, s"$mainClass did not end within $seconds s; it printed: $said")
      assert(process.exitValue == 0, s"$mainClass ended with ${process.exitValue}: $said")
      said
    } finally {
      process.destroyForcibly()
      Files.delete(out)
    }
  }
}
