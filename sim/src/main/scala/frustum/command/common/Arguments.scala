package frustum.command.common

import frustum.contract.InputError
import frustum.driver.linear.Vector3
import frustum.engine.{EngineEntry, EngineTable}
import scopt.{OEffect, OParser, Read}
import java.nio.file.{InvalidPathException, Path, Paths}

/** What the parsers of all commands share: kinds of values with messages that say what to write, and errors
  * in one line.
  */
object Arguments {

  /** The arguments, or None when help was asked for and printed. A parser needs no `--help` of its own. */
  def parse[A](command: String, parser: OParser[_, A], args: Seq[String], defaults: A): Option[A] =
    if (args.contains("--help")) {
      println(OParser.usage(parser))
      None
    } else {
      val (parsed, effects) = OParser.runParser(parser, args, defaults)
      effects.collectFirst { case OEffect.ReportError(message) => message }.foreach { message =>
        throw InputError(s"${message.stripPrefix("Error: ")}; see $command --help")
      }
      parsed
    }

  private def refuse(what: String): Nothing = throw new IllegalArgumentException(what)

  private def number(text: String): Double =
    text.toDoubleOption.filter(_.isFinite).getOrElse(refuse(s"'$text' is not a finite number"))

  /** Finite numbers. */
  val finite: Read[Double] = Read.reads(number)

  /** Finite numbers above zero. */
  val positive: Read[Double] =
    Read.reads(t => Some(number(t)).filter(_ > 0).getOrElse(refuse(s"$t is not above 0")))

  val vector: Read[Vector3] = Read.reads { text =>
    text.split(",", -1) match {
      case Array(x, y, z) => Vector3(number(x), number(y), number(z))
      case _              => refuse(s"'$text' is not three numbers x,y,z without blanks")
    }
  }

  /** WIDTHxHEIGHT. */
  val size: Read[(Int, Int)] = Read.reads {
    case s"${w}x$h" if w.toIntOption.exists(_ > 0) && h.toIntOption.exists(_ > 0) => (w.toInt, h.toInt)
    case text => refuse(s"'$text' is not a size such as 240x320")
  }

  /** 0xRRGGBB from six hexadecimal digits. */
  val color: Read[Int] = Read.reads { text =>
    if (text.matches("[0-9a-fA-F]{6}")) Integer.parseInt(text, 16)
    else refuse(s"'$text' is not six hexadecimal digits RRGGBB")
  }

  val count: Read[Int] = Read.reads { text =>
    text.toIntOption.filter(n => n >= 1 && n <= 10000).getOrElse(refuse(
      s"'$text' is not a whole number from 1 to 10000"
    ))
  }

  val seed: Read[Long] = Read.reads(t => t.toLongOption.getOrElse(refuse(s"'$t' is not a whole number")))

  val file: Read[Path] = Read.reads { text =>
    try { if (text.isEmpty) refuse("a file name is empty") else Paths.get(text) }
    catch { case e: InvalidPathException => refuse(s"'$text' is not a file name: ${e.getReason}") }
  }

  /** An engine by name. */
  def engine[E <: EngineEntry[Nothing, Any]](table: EngineTable[E]): Read[E] = Read.reads(table.byName)

  /** One of a few names. */
  def oneOf[A](choices: (String, A)*): Read[A] = Read.reads { text =>
    choices.toMap.getOrElse(text, refuse(s"'$text' is none of ${choices.map(_._1).mkString(", ")}"))
  }
}
