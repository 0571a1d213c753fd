package frustum.raster.link

import frustum.contract.raster.{Command, PackedTriangle, PackedVertex, RasterConfig, RenderStateLayout}
import scala.util.Random

/** Random commands for the link, right and wrong ones. */
final class LinkTraffic(config: RasterConfig, random: Random) {
  private def oneIn(n: Int) = random.nextInt(n) == 0
  private def pick[A](values: A*): A = values(random.nextInt(values.length))

  private def clearColor(): Int = config.clearColor.filterNot(_ => oneIn(6)).getOrElse(random.nextInt(65536))

  def vertex(): Seq[Int] = {
    val (most, mostSt) = (config.ranges.maxXy, config.ranges.maxSt)
    def coordinate(pixels: Int) =
      if (oneIn(6)) pick(most, -most, 0, 8, 7, 9, -8, 16 * pixels, 16 * pixels - 8, 16 * pixels - 9, 16 * pixels + 8)
      else if (oneIn(40)) pick(-most - 1, most + 1, 32767, -32768)
      else random.nextInt(16 * pixels * 2) - 8 * pixels
    def texture() =
      if (oneIn(8)) pick(0, mostSt + 1, -mostSt - 1, 1 << 24, -(1 << 24), 1 << 25, -(1 << 26), 65536)
      else if (oneIn(6)) pick(mostSt, -mostSt)
      else random.between(-mostSt, mostSt + 1)
    val mantissa = if (oneIn(30)) random.nextInt(65536) else 32768 + random.nextInt(32768)
    val (s, t) = (texture(), texture())
    Seq(
      coordinate(config.width) & 0xffff,
      coordinate(config.height) & 0xffff,
      random.nextInt(65536),
      mantissa,
      random.nextInt(32) << 11 | (s >> 16 & 0x7ff),
      s & 0xffff,
      random.nextInt(32) << 11 | (t >> 16 & 0x7ff),
      t & 0xffff,
      random.nextInt(65536),
      random.nextInt(65536)
    )
  }

  private def indices(known: Int): Seq[Int] = {
    def index() = if (oneIn(25)) random.nextInt(1024) else random.nextInt(known.max(1))
    PackedTriangle(0, index(), index(), index()).words match { case Seq(a, b) => Seq(a | random.nextInt(4) << 14, b) }
  }

  private def region(): Seq[Int] = {
    def range(tiles: Int) = {
      val (a, b) = (random.nextInt(tiles), random.nextInt(tiles))
      if (oneIn(40)) pick(a.max(b) << 8 | tiles, 0x0100, 0xff00 | b, 0x2020) else (a.min(b) << 8) | a.max(b)
    }
    Seq(range(config.tilesX), range(config.tilesY))
  }

  /** Gives every vertex of both banks a tag that no other frame has: what the memory holds at power-up is chance. */
  def fill(): Seq[Int] = {
    val vertex = PackedVertex(0, 0, 0, 32768, 0, 0, 0, 0, 0, 0, 0).words
    val vertices =
      (0 until config.maxVertices).grouped(11).map(g => (Command.Vertices, g.head +: g.flatMap(_ => vertex)))
    val one =
      (Command.Begin, Seq(127, config.clearColor.getOrElse(0), 0, 0)) +: vertices.toSeq :+ ((
        Command.Draw,
        Seq(config.maxVertices, 0)
      ))
    bytes(one ++ one, errors = false)
  }

  /** Of every other one all bits are as hardware has them that are constant there. */
  private def state(): Seq[Int] = {
    val fits = oneIn(2)
    RenderStateLayout.encode(RenderStateLayout.fields.map { field =>
      val fixed = config.fixed(field)
      val value = random.nextInt() & field.ones
      field -> (if (fits) value & ~fixed.mask | fixed.value else value)
    }: _*)
  }

  /** One frame as (command, payload). */
  def frame(number: Int): Seq[(Command, Seq[Int])] = {
    val counts = Seq.fill(1 + random.nextInt(5))(1 + random.nextInt(11))
    var first = if (oneIn(5)) (config.maxVertices - 6).max(0) else 0
    val vertices = counts.map { n =>
      val at = if (oneIn(30)) random.nextInt(65536) else first
      first += n
      (Command.Vertices, at +: Seq.fill(n)(vertex()).flatten)
    }
    val states = Seq.fill(random.nextInt(4))(
      (Command.State, (if (oneIn(10)) random.nextInt(65536) else random.nextInt(16)) +: state())
    )
    val named = states.map(_._2.head)

    /** Most triangles name a state of the frame. */
    def stateIndex() = if (named.isEmpty || oneIn(4)) random.nextInt(16) else pick(named: _*)
    val groups = Seq.fill(1 + random.nextInt(3))(1 + random.nextInt(30))
    val triangles = groups.map { n =>
      (
        Command.Triangles,
        (if (oneIn(15)) random.nextInt(65536) else stateIndex()) +: Seq.fill(n)(indices(first)).flatten
      )
    }
    val texels = Seq.fill(random.nextInt(2)) {
      val blocks = config.textureTexels / 16
      val at = if (oneIn(4)) pick(blocks - 1, blocks - 3, blocks, 65535, 4096, 4095) else random.nextInt(blocks)
      (Command.Texels, at +: Seq.fill(1 + random.nextInt(100))(random.nextInt(65536)))
    }
    val sentTriangles = if (oneIn(5)) random.nextInt(100) else groups.sum
    val draw = Seq((Command.Draw, Seq(counts.sum, sentTriangles)))
    val begin = Seq((Command.Begin, Seq(number, clearColor()) ++ region()))
    (if (oneIn(12)) Nil else begin) ++ random.shuffle(states ++ texels) ++ vertices ++ triangles ++
      (if (oneIn(12)) Nil else draw)
  }

  /** The bytes of commands, some of them spoilt where `errors`. */
  def bytes(commands: Seq[(Command, Seq[Int])], errors: Boolean): Seq[Int] =
    commands.flatMap { case (command, payload) =>
      val good = Command.encode(command, payload)
      if (!errors || !oneIn(15)) good
      else {
        val at = random.nextInt(good.length)
        pick(
          good.patch(at, Seq(good(at) ^ (1 << random.nextInt(8))), 1),
          good.patch(at, Nil, 1),
          good.patch(at, Seq(random.nextInt(256)), 0),
          good.take(at),
          Command.encode(Command(random.nextInt(16), "unknown", Nil, ""), payload),
          Command.encode(command, payload.drop(1)),
          Command.Flag +: good
        )
      }
    }
}
