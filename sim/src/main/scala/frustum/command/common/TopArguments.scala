package frustum.command.common

import frustum.boards.{BoardTop, Tops}
import frustum.boards.flow.Nextpnr
import frustum.contract.InputError
import scopt.{OEffect, OParser}

/** Arguments of the commands that build a top. */
final case class TopArguments(
    top: String = "",
    seeds: Int = 1,
    placer: String = Nextpnr.Static,
    ecp5: Boolean = false,
    help: Boolean = false
) {
  def find: BoardTop = Tops.find(top).getOrElse(
    throw InputError(s"argument TOP: there is no top '$top'; choose one of ${Tops.all.map(_.name).mkString(", ")}")
  )
}

object TopArguments {
  private val builder = OParser.builder[TopArguments]

  /** @param seeds whether the command places, and so takes `--seeds` */
  def parser(command: String, summary: String, seeds: Boolean): OParser[_, TopArguments] = {
    import builder._
    val common = OParser.sequence(
      programName(s"./sbt $command"),
      head(s"$command: $summary"),
      arg[String]("TOP").optional().action((name, a) => a.copy(top = name))
        .text(s"the design: ${Tops.all.map(_.name).mkString(", ")}"),
      opt[Unit]("help").action((_, a) => a.copy(help = true)).text("prints this")
    )
    if (!seeds) common
    else
      OParser.sequence(
        common,
        opt[Int]("seeds").valueName("N").action((n, a) => a.copy(seeds = n))
          .validate(n => if (n >= 1 && n <= 100) success else failure(s"argument --seeds: $n is outside 1..100"))
          .text("placements, with placer seeds 1 to N; the slowest is what is reported (default 1)"),
        opt[String]("placer").valueName(Nextpnr.Placers.mkString("|")).action((p, a) => a.copy(placer = p))
          .validate(p =>
            if (Nextpnr.Placers.contains(p)) success
            else failure(s"argument --placer: '$p' is none of ${Nextpnr.Placers.mkString(", ")}")
          )
          .text(s"nextpnr's (default ${Nextpnr.Static})"),
        opt[Unit]("ecp5").action((_, a) => a.copy(ecp5 = true))
          .text("the same design on Lattice's LFE5U-85F, for its figures alone: TOP-ecp5.json, no file for a board")
      )
  }

  /** The arguments, or None when help was asked for and printed. */
  def parse(parser: OParser[_, TopArguments], args: Seq[String]): Option[TopArguments] = {
    val (parsed, effects) = OParser.runParser(parser, args, TopArguments())
    if (parsed.exists(_.help) || args.contains("--help")) {
      println(OParser.usage(parser))
      None
    } else {
      effects.collectFirst { case OEffect.ReportError(message) => message }.foreach { message =>
        throw InputError(s"${message.replaceFirst("^Error: ", "")}; see --help")
      }
      if (parsed.exists(_.top.isEmpty))
        throw InputError(s"argument TOP is missing; choose one of ${Tops.all.map(_.name).mkString(", ")}")
      parsed
    }
  }
}
