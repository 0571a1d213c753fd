package frustum.contract.raster

import frustum.contract.Layout

/** One command of the stream, for the decoder, the driver and docs: what its payload of 16-bit words is made of. */
final case class Command(opcode: Int, name: String, parts: Seq[Part], note: String)

/** A record of a command's payload, or any number of them, one at least, where `repeated`. */
final case class Part(layout: Layout, repeated: Boolean = false)

/** The command set. A frame on the wire is
  * {{{ 0x7E  opcode  length  payload (2 * length bytes, big-endian words)  crc (2 bytes, big-endian) }}}
  * where after the flag 0x7E every byte 0x7E or 0x7D is sent as 0x7D followed by the byte xor 0x20, so that a flag
  * always starts a command. The checksum is CRC-16/CCITT-FALSE (polynomial 0x1021, start 0xFFFF) over the unescaped
  * opcode, length and payload. A command whose checksum or length is wrong is dropped and counted.
  */
object Command {
  val Flag = 0x7e
  val Escape = 0x7d
  val EscapeXor = 0x20

  /** Most payload words of a command: a lost byte costs at most this much. */
  val MaxWords = 120

  val Begin = Command(
    0x01,
    "begin",
    Seq(Part(BeginLayout)),
    "Starts a frame, or one pass of it, in a free bank of the store; waits until there is one. A refused one ends " +
      "the frame before it as well."
  )

  val State = Command(
    0x02,
    "state",
    Seq(Part(StateHeadLayout), Part(RenderStateLayout)),
    "Sets a render state of the frame. No state is kept from the frame before."
  )

  val Vertices = Command(
    0x03,
    "vertices",
    Seq(Part(VerticesHeadLayout), Part(VertexLayout, repeated = true)),
    "Stores vertices at consecutive indices. A vertex out of range is refused and counted."
  )

  val Triangles = Command(
    0x04,
    "triangles",
    Seq(Part(TrianglesHeadLayout), Part(TriangleLayout, repeated = true)),
    "Appends triangles; they are drawn in this order. A triangle that names a vertex or a render state not sent in " +
      "this frame is refused and counted."
  )

  val Texels = Command(
    0x05,
    "texels",
    Seq(Part(TexelsHeadLayout), Part(TexelLayout, repeated = true)),
    "Writes texel memory. Waits until no frame is being drawn. If the texels exceed the memory, those that fit are " +
      "written and the command counts as refused."
  )

  val Draw = Command(
    0x06,
    "draw",
    Seq(Part(DrawLayout)),
    "Starts the rasterizer on the bank. Counts that differ from what arrived mark the frame incomplete (counted)."
  )

  val all: Seq[Command] = Seq(Begin, State, Vertices, Triangles, Texels, Draw)

  /** CRC-16/CCITT-FALSE. */
  def crc(bytes: Seq[Int]): Int = bytes.foldLeft(0xffff) { (c, byte) =>
    (0 until 8).foldLeft(c ^ (byte << 8)) { (x, _) =>
      if ((x & 0x8000) != 0) ((x << 1) ^ 0x1021) & 0xffff else (x << 1) & 0xffff
    }
  }

  /** The bytes of one command on the wire. */
  def encode(command: Command, payload: Seq[Int]): Seq[Int] = {
    require(payload.length <= MaxWords, s"${command.name}: ${payload.length} payload words, at most $MaxWords")
    require(payload.forall(w => w >= 0 && w <= 0xffff), s"${command.name}: a payload word is outside 0..65535")
    val body = Seq(command.opcode, payload.length) ++ payload.flatMap(w => Seq(w >> 8, w & 255))
    val sum = crc(body)
    Flag +: (body ++ Seq(sum >> 8, sum & 255)).flatMap { b =>
      if (b == Flag || b == Escape) Seq(Escape, b ^ EscapeXor) else Seq(b)
    }
  }
}
