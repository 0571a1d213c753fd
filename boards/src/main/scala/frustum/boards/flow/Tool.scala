package frustum.boards.flow

import java.io.File
import java.lang.ProcessBuilder.Redirect
import java.nio.file.{Files, Path}
import java.util.concurrent.TimeUnit
import scala.concurrent.duration.Duration
import scala.jdk.CollectionConverters._
import scala.math.Ordering.Implicits._

/** A program of the flow: its command and its name. */
final case class Tool(name: String, version: String, command: Seq[String], environment: Map[String, String]) {

  /** Runs in `directory`, everything it prints going to `log` there; returns its exit code. */
  def run(directory: Path, log: String, arguments: Seq[String]): Int =
    runWithin(Duration.Inf)(directory, log, arguments).get

  /** The same; None, and the program is stopped, when it has not ended within a limit. */
  def runWithin(limit: Duration)(directory: Path, log: String, arguments: Seq[String]): Option[Int] = {
    val builder = new ProcessBuilder((command ++ arguments).asJava)
      .directory(directory.toFile)
      .redirectErrorStream(true)
      .redirectInput(Redirect.from(new File("/dev/null")))
      .redirectOutput(directory.resolve(log).toFile)
    environment.foreach { case (key, value) => builder.environment.put(key, value) }
    val process = builder.start()
    def stop(): Unit = {
      process.descendants.forEach(child => child.destroy())
      process.destroy()
    }
    try
      if (!limit.isFinite) Some(process.waitFor())
      else if (process.waitFor(limit.toMillis, TimeUnit.MILLISECONDS)) Some(process.exitValue)
      else { stop(); None }
    catch { case interrupted: InterruptedException => stop(); throw interrupted }
  }
}

/** A tool is missing or too old; the message says how to get it. */
final case class MissingTool(message: String) extends RuntimeException(message)

/** A tool failed, or the design breaks a rule of the flow. */
final case class FlowFault(message: String) extends RuntimeException(message)

object Tool {

  /** Every executable of this name on PATH, in order. */
  def onPath(name: String): Seq[String] =
    sys.env.getOrElse("PATH", "").split(File.pathSeparator).toSeq
      .filter(_.nonEmpty)
      .map(new File(_, name))
      .filter(f => f.isFile && f.canExecute)
      .map(_.getPath)
      .distinct

  /** The first of this name on PATH whose version, printed with `flag`, is `oldest` or newer. */
  def native(name: String, flag: String, oldest: (Int, Int) = (0, 0)): Option[Tool] =
    onPath(name).flatMap { path =>
      version(output(Seq(path, flag))).filter(_ >= oldest).map(v => Tool(name, s"${v._1}.${v._2}", Seq(path), Map()))
    }.headOption

  /** What a program prints, both streams together; empty when it cannot be started. */
  def output(command: Seq[String], environment: Map[String, String] = Map()): String = {
    val builder = new ProcessBuilder(command.asJava).redirectErrorStream(true)
    environment.foreach { case (key, value) => builder.environment.put(key, value) }
    try {
      val process = builder.start()
      process.getOutputStream.close()
      val text = new String(process.getInputStream.readAllBytes())
      process.waitFor()
      text
    } catch { case _: java.io.IOException => "" }
  }

  /** The first `major.minor` in what a tool prints: (0, 40) of "Yosys 0.40+25 ...". */
  def version(text: String): Option[(Int, Int)] =
    """(\d+)\.(\d+)""".r.findFirstMatchIn(text).map(m => (m.group(1).toInt, m.group(2).toInt))

  /** The error lines of a log, or its last lines. */
  def faults(log: Path): String = {
    val lines = Files.readAllLines(log).asScala.toSeq.filter(_.nonEmpty)
    val errors = lines.filter(_.startsWith("ERROR"))
    (if (errors.nonEmpty) errors.take(1) else lines.takeRight(1)).mkString("; ")
  }
}
