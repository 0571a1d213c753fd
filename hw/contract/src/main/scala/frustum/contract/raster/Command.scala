package frustum.contract.raster

/** One command of the stream: opcode, name, and its payload in 16-bit words, for the decoder, the driver and docs. */
final case class Command(opcode: Int, name: String, fields: Seq[Field], note: String)

/** A field of a command's payload: `words` 16-bit words, or any number of groups of `words` where `repeated`. */
final case class Field(name: String, words: Int, note: String, repeated: Boolean = false)

/** The command set. A frame on the wire is
  * {{{ 0x7E  opcode  length  payload (2 * length bytes, big-endian words)  crc (2 bytes, big-endian) }}}
  * where after the flag 0x7E every byte 0x7E or 0x7D is sent as 0x7D followed by the byte xor 0x20, so that a flag
  * always starts a command. The checksum is CRC-16/CCITT-FALSE (polynomial 0x1021, start 0xFFFF) over the unescaped
  * opcode, length and payload. A command whose checksum or length is wrong is dropped and counted, nothing else.
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
    Seq(
      Field(
        "frame",
        1,
        "frame number modulo 128, another for each frame: vertices sent under another number are not drawn"
      ),
      Field("clearColor", 1, "RGB565"),
      Field(
        "region",
        2,
        "tiles to draw, from the top left: x0 << 8 | x1, y0 << 8 | y1, inclusive; 16 x 16 pixels each in the tops"
      )
    ),
    "Starts a frame, or one pass of it, in a free bank of the store; waits until there is one. One that is refused ends the frame before it all the same."
  )

  val State = Command(
    0x02,
    "state",
    Seq(
      Field("index", 1, "0..15"),
      Field("state", 2, "see RenderState")
    ),
    "Sets a render state of the frame."
  )

  val Vertices = Command(
    0x03,
    "vertices",
    Seq(
      Field("first", 1, "index of the first vertex, 0..1023"),
      Field("vertex", PackedVertex.WireWords, "see PackedVertex", repeated = true)
    ),
    "Stores vertices at consecutive indices. A vertex out of range is refused and counted."
  )

  val Triangles = Command(
    0x04,
    "triangles",
    Seq(
      Field("state", 1, "render state of these triangles, 0..15"),
      Field(
        "indices",
        2,
        "v0 << 20 | v1 << 10 | v2; drawn when v0, v1, v2 turn clockwise on the screen",
        repeated = true
      )
    ),
    "Appends triangles; they are drawn in this order. A triangle that names a vertex not sent in this frame is refused and counted."
  )

  val Texels = Command(
    0x05,
    "texels",
    Seq(
      Field("address", 1, "first texel / 16"),
      Field("texel", 1, "RGB565 or RGBA4444", repeated = true)
    ),
    "Writes texel memory. Waits until no frame is being drawn. Of one that runs beyond the memory, what lies within is written, and it counts as refused."
  )

  val Draw = Command(
    0x06,
    "draw",
    Seq(
      Field("vertices", 1, "vertices sent since begin"),
      Field("triangles", 1, "triangles sent since begin")
    ),
    "Hands the bank to the rasterizer. Counts that differ from what arrived mark the frame incomplete (counted)."
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
