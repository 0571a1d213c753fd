package frustum.command

import frustum.contract.{Layout, Slice}
import frustum.contract.raster.{Command, CommandShape, RenderState, RenderStateLayout, VertexLayout}
import java.nio.file.{Files, Paths}

/** Prints `docs/commands.md` from the command table and the formats themselves, so that the page is what the hardware
  * and the driver obey: `./sbt "sim/runMain frustum.command.CommandPage"` writes it.
  */
object CommandPage {
  val file = "docs/commands.md"

  def main(args: Array[String]): Unit = { Files.writeString(Paths.get(file), text); println(s"wrote $file") }

  def text: String =
    (Seq(
      "# Commands",
      "*Printed from the table `frustum.contract.raster.Command` and the layouts beside it by `./sbt \"sim/runMain " +
        "frustum.command.CommandPage\"`; a test fails when it is stale. Edit those, not this page.*"
    ) ++ CommandPageText.framing ++ overview ++ Command.all.flatMap(section) ++ vertex ++ state ++
      CommandPageText.flow ++ CommandPageText.status).map(WrappedText(_)).mkString("", "\n\n", "\n")

  private def hex(v: Int, digits: Int = 2): String = s"0x%0${digits}X".format(v)

  private def table(head: Seq[String], rows: Seq[Seq[String]]): String =
    (head +: head.map(_ => "---") +: rows).map(_.map(_.replace("|", "\\|")).mkString("| ", " | ", " |")).mkString("\n")

  /** 3, "3 to 5", or "5, 7 .. 119". */
  private def lengths(command: Command): String = CommandShape.lengths(command) match {
    case Seq(one)                      => one.toString
    case all if all(1) - all.head == 1 => s"${all.head} to ${all.last}"
    case all                           => s"${all.head}, ${all(1)} .. ${all.last}"
  }

  private def overview: Seq[String] = Seq(
    "## The commands",
    table(
      Seq("opcode", "command", "words", "what it does"),
      Command.all.map(c => Seq(hex(c.opcode), s"[${c.name}](#${c.name})", lengths(c), c.note))
    ),
    "A frame is `begin`, any `state`, `vertices` and `triangles`, then `draw`; vertices and states come before the " +
      "triangles that name them. `texels` may stand anywhere. A frame that is incomplete is counted and drawn with " +
      "what has arrived.",
    "A picture may be drawn in several passes, each from `begin` to `draw`, where it has more than the store holds. " +
      "Their regions must be disjoint: a pass clears its region, so it removes what another one drew there. Nothing " +
      "outside the region changes."
  )

  /** Records with a section of their own. */
  private val described: Map[Layout, String] = Map(VertexLayout -> "vertex", RenderStateLayout -> "render state")

  private def section(c: Command): Seq[String] = s"### ${c.name}" +: c.parts.zipWithIndex.flatMap { case (part, n) =>
    val words = if (part.layout.words == 1) "1 word" else s"${part.layout.words} words"
    val times = if (part.repeated) "Then, once or more," else "Then"
    val link = described.get(part.layout).fold("")(name => s" a [$name](#${name.replace(' ', '-')}).")
    val head = Option.when(n > 0)(s"$times $words:$link")
    head.toSeq ++ Option.unless(described.contains(part.layout))(fields(part.layout))
  }

  /** A layout's table: where each field lies as "word 4, bits 15..11". */
  private def fields(layout: Layout): String = table(
    Seq("field", "place", "content"),
    layout.fields.map(f => Seq(s"`${f.name}`", f.slices.map(place(layout, _)).mkString("; "), f.meaning))
  )

  private def place(layout: Layout, s: Slice): String = s"word ${s.word}" + (
    if (s.width == layout.wordBits) "" else if (s.width == 1) s", bit ${s.low}" else s", bits ${s.high}..${s.low}"
  )

  private def vertex: Seq[String] = Seq(
    "## Vertex",
    s"${VertexLayout.words} words, ${2 * VertexLayout.words} bytes (`PackedVertex`); bits not named are ignored.",
    fields(VertexLayout),
    "The centre of the pixel i columns right of and j rows below the top left one is at x = 16 i + 8, y = 16 j + 8. " +
      "A pixel is drawn where its centre lies in the triangle; on an edge, where that is a top or a left one. So " +
      "triangles that share an edge draw each pixel once.",
    "`s` and `t` are not divided by w: the hardware multiplies them by 1/w, interpolates and divides again. A " +
      "coordinate of 0 is the border before the first texel, and what is exactly a texel's border belongs to the " +
      "texel above it, within [limits](numbers.md#what-is-exact-and-what-is-not).",
    "A vertex outside these ranges is refused: it is counted, and every triangle that names it is refused as well. " +
      "Without perspective (orthographic views, screen-space drawing) give every vertex the same q, for example " +
      s"mantissa 32768, exponent 16: w = 1."
  )

  private def state: Seq[String] = Seq(
    "## Render state",
    s"${RenderStateLayout.words} words (`RenderState`); ${RenderState.Count} states a frame. Those that triangles " +
      "name must be sent in every frame: states are not kept from one to the next, as each frame has a bank of the " +
      "store to itself, and a copy from bank to bank would take logic cells to save 11 bytes a state.",
    fields(RenderStateLayout),
    "Every frame, or pass, starts with a depth of 65535 at each of its pixels. So with 1 (less) a fragment at 65535 " +
      "is never drawn; with 3 (less or equal) it is.",
    "Texels lie row by row from the bottom row (t = 0) up, 16 bits each, red in the most significant bits. With " +
      "RGB565 the fragment's alpha is the vertex's."
  )
}
