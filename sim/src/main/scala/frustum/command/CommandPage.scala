package frustum.command

import frustum.contract.raster.{
  Combine,
  Command,
  CommandShape,
  DepthFunction,
  PackedVertex,
  RenderState,
  TexelFormat,
  TextureRef,
  Wrap
}
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
      "*Printed from the table `frustum.contract.raster.Command` and the formats beside it by " +
        "`./sbt \"sim/runMain frustum.command.CommandPage\"`; a test fails when it is stale. Edit those, not this page.*"
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
    "A frame is `begin`, any `state`, `vertices` and `triangles`, then `draw`; vertices come before the triangles that " +
      "name them, states before `draw`. `texels` may stand anywhere. A frame that is incomplete is counted and drawn with what " +
      "has arrived."
  )

  private def section(c: Command): Seq[String] = Seq(
    s"### ${c.name}",
    table(
      Seq("field", "words", "content"),
      c.fields.map(f => Seq(f.name, if (f.repeated) s"${f.words} each, once or more" else f.words.toString, f.note))
    )
  )

  /** Where a field lies: the bits of each word that any of `values` changes against `zero`, as "word 4, bits 15..11". */
  private def place(zero: Seq[Int], values: Seq[Seq[Int]]): String =
    zero.indices.flatMap { i =>
      val mask = values.map(_(i) ^ zero(i)).foldLeft(0)(_ | _)
      Option.when(mask != 0) {
        val (high, low) = (31 - Integer.numberOfLeadingZeros(mask), Integer.numberOfTrailingZeros(mask))
        require(mask == (2 << high) - (1 << low), s"a field has holes in word $i: ${hex(mask, 4)}")
        if (high - low == 15) s"word $i" else if (high == low) s"word $i, bit $low" else s"word $i, bits $high..$low"
      }
    }.mkString("; ")

  private def vertex: Seq[String] = {
    val zero = PackedVertex(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)
    def row(name: String, full: PackedVertex, content: String) =
      Seq(name, place(zero.words, Seq(full.words)), content)
    val most = s"magnitude at most ${PackedVertex.MaxXy}"
    val turns = s"repeats, two's complement, 16 fraction bits; magnitude at most ${PackedVertex.MaxSt}"
    Seq(
      "## Vertex",
      s"${PackedVertex.WireWords} words, ${2 * PackedVertex.WireWords} bytes (`PackedVertex`); bits not named are ignored.",
      table(
        Seq("field", "place", "content"),
        Seq(
          row("x", zero.copy(x = -1), s"1/16 pixel right of the screen's left edge, two's complement; $most"),
          row("y", zero.copy(y = -1), s"1/16 pixel below the screen's top edge, two's complement; $most"),
          row("z", zero.copy(z = 65535), "depth, 0 near to 65535 far"),
          row("q mantissa", zero.copy(qMantissa = 65535), "1/w = mantissa * 2^(exponent - 31); 32768 to 65535"),
          row("q exponent", zero.copy(qExponent = 31), "0 to 31"),
          row("s", zero.copy(s = -1), turns),
          row("t", zero.copy(t = -1), turns),
          row("r", zero.copy(r = 255), "0 to 255"),
          row("g", zero.copy(g = 255), "0 to 255"),
          row("b", zero.copy(b = 255), "0 to 255"),
          row("a", zero.copy(a = 255), "0 to 255, 255 opaque")
        )
      ),
      "A vertex outside these ranges is refused: it is counted, and every triangle that names it is refused as well. " +
        "Without perspective (orthographic views, screen-space drawing) give every vertex the same q, for example " +
        s"mantissa 32768, exponent 16: w = 1."
    )
  }

  private def state: Seq[String] = {
    val texture = TextureRef(0, 3, 3, TexelFormat.Rgb565)
    val zero = RenderState(Some(texture), depth = DepthFunction.Never, depthWrite = false)
    def row(name: String, content: String)(values: RenderState*) =
      Seq(name, place(zero.words, values.map(_.words)), content)
    def textured(t: TextureRef) = zero.copy(texture = Some(t))
    def codes(all: (Int, String)*) = all.map { case (code, name) => s"$code $name" }.mkString(", ")
    val combines = Seq(Combine.ColorOnly, Combine.Replace, Combine.Modulate)
    val formats = Seq(TexelFormat.Rgb565, TexelFormat.Rgba4444)
    val wraps = Wrap.all.map(w => w.code -> w.toString.toLowerCase)
    Seq(
      "## Render state",
      s"2 words (`RenderState`); ${RenderState.Count} states a frame. Those that triangles name must be sent in every frame.",
      table(
        Seq("field", "place", "content"),
        Seq(
          row("texture base", "first texel / 64")((0 to 511).map(b => textured(texture.copy(base = b))): _*),
          row(
            "texture width",
            "log2 of the width, less 3: 8 to 128 texels"
          )((3 to 7).map(n => textured(texture.copy(log2Width = n))): _*),
          row(
            "texture height",
            "log2 of the height, less 3"
          )((3 to 7).map(n => textured(texture.copy(log2Height = n))): _*),
          row(
            "texel format",
            codes(formats.map(f => f.code -> f.toString.toUpperCase): _*)
          )(formats.map(f => textured(texture.copy(format = f))): _*),
          row("wrap s", codes(wraps: _*))(Wrap.all.map(w => zero.copy(wrapS = w)): _*),
          row("wrap t", "the same")(Wrap.all.map(w => zero.copy(wrapT = w)): _*),
          row(
            "combine",
            codes(combines.map(_.code).zip(Seq("vertex colour alone", "texel alone", "texel * vertex colour")): _*)
          )(
            combines.map(c => zero.copy(combine = c)): _*
          ),
          row(
            "depth function",
            "sum of 1 less, 2 equal, 4 greater: the fragment passes when its depth is so against the stored one"
          )(
            (0 to 7).map(f => zero.copy(depth = DepthFunction.decode(f))): _*
          ),
          row("depth write", "1: a fragment that passes stores its depth")(zero.copy(depthWrite = true)),
          row("blend", "1: source * alpha + destination * (1 - alpha)")(zero.copy(blend = true)),
          row(
            "alpha reference",
            "fragments whose five-bit alpha is lower are dropped; 0 keeps all"
          )((0 to 31).map(a => zero.copy(alphaRef = a)): _*)
        )
      ),
      "Texels lie row by row from the bottom row (t = 0) up, 16 bits each, red in the most significant bits. With RGB565 " +
        "the fragment's alpha is the vertex's."
    )
  }
}
