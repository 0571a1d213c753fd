package frustum.model.raster.link

import frustum.contract.raster.{Command, PackedVertex, RasterConfig, RenderState, StoreLayout, TileRegion}
import scala.collection.mutable.ArrayBuffer

/** A job as handed to the rasterizer, with a copy of its bank. */
final case class Job(bank: Int, triangleCount: Int, clearColor: Int, region: TileRegion, store: IndexedSeq[Long])

/** What a checked command does, see [[frustum.raster.link.CommandDecoder]]. Waiting is not modelled: it changes no result.
  *
  * Words of a bank that were never written are [[CommandDecoder.Unwritten]], fields marked `-` in the layout are 0.
  */
final class CommandDecoder(config: RasterConfig) {
  val layout = StoreLayout(config)
  val banks = Array.fill(2, layout.bankWords)(CommandDecoder.Unwritten)
  val texels = Array.fill(config.textureTexels)(0)
  val jobs = ArrayBuffer.empty[Job]

  var accepted, refused, verticesRefused, trianglesRefused, incomplete = 0L

  private var open = false
  private var bank = 0
  private var tag = 0
  private var clearColor = 0
  private var region = TileRegion(0, 0, 0, 0)
  private var vertices = 0 // arrived
  private var triangles = 0 // arrived
  private var stored = 0

  def execute(opcode: Int, words: Seq[Int]): Unit = {
    val done = Command.all.find(_.opcode == opcode) match {
      case Some(Command.Begin)     => begin(words)
      case Some(Command.Texels)    => writeTexels(words.head, words.tail)
      case _ if !open              => false
      case Some(Command.State)     => writeState(words)
      case Some(Command.Vertices)  => writeVertices(words.head, words.tail); true
      case Some(Command.Triangles) => writeTriangles(words.head, words.tail)
      case Some(Command.Draw)      => draw(words(0), words(1)); true
      case _                       => false
    }
    if (done) accepted += 1 else refused += 1
  }

  private def begin(w: Seq[Int]): Boolean = {
    val Seq(x0, x1, y0, y1) = w.drop(2).flatMap(v => Seq(v >> 8, v & 255))
    open = config.clearColor.forall(_ == w(1)) && x0 <= x1 && x1 < config.tilesX && y0 <= y1 && y1 < config.tilesY
    tag = w(0) & 127
    clearColor = w(1)
    region = TileRegion(x0, y0, x1, y1)
    vertices = 0
    triangles = 0
    stored = 0
    open
  }

  private def writeState(w: Seq[Int]): Boolean = {
    val word = w(2) << 16 | w(1)
    val inRange = w(0) < RenderState.Count && ((word ^ config.fixed.value) & config.fixed.mask) == 0
    if (inRange && !config.fixed.whole) banks(bank)(layout.states + w(0)) = pair(w(1), w(2))
    inRange
  }

  private def pair(high: Int, low: Int): Long = (high.toLong << 16) | low

  private def writeVertices(first: Int, w: Seq[Int]): Unit =
    for ((v, i) <- w.grouped(PackedVertex.WireWords).zipWithIndex) {
      vertices = (vertices + 1) & 0xfff
      val index = first + i
      if (index >= config.maxVertices) verticesRefused += 1
      else writeVertex(layout.vertexWords * index, v)
    }

  /** The words are checked as they come; from the first one out of range on nothing is written but a tag that differs. */
  private def writeVertex(at: Int, v: Seq[Int]): Unit = {
    val out = (0 until 5).map(p => outOfRange(v, 2 * p + 2))
    val words = IndexedSeq(
      pair(v(0), v(1)),
      pair(v(2), v(3)),
      pair(v(4), v(5)) & ~(3L << 25),
      (pair(v(6), v(7)) & 0x1ffffff) | (tag ^ (if (out(3)) 64 else 0)).toLong << 25,
      pair(v(8), v(9))
    )
    for (p <- words.indices if p == 3 || !out(p)) banks(bank)(at + p) = words(p)
    if (out.last) verticesRefused += 1
  }

  /** Whether the first `known` words of a vertex suffice to refuse it: what is not known is taken to be in range. */
  private def outOfRange(v: Seq[Int], known: Int): Boolean =
    PackedVertex.decode(v.take(known) ++ Seq(
      0, 0, 0, 0x8000, 0, 0, 0, 0, 0, 0
    ).drop(known)).fault(config.ranges).isDefined

  private def writeTriangles(state: Int, w: Seq[Int]): Boolean = {
    val inRange = state < RenderState.Count
    if (inRange) w.grouped(2).foreach(t => writeTriangle(state, pair(t(0), t(1)) & 0x3fffffff))
    inRange
  }

  private def writeTriangle(state: Int, indices: Long): Unit = {
    triangles = (triangles + 1) & 0xfff
    val corners = Seq(20, 10, 0).map(shift => ((indices >> shift) & 1023).toInt)
    val sent = corners.forall { v =>
      v < config.maxVertices && banks(bank)(layout.vertexWords * v + 3) != CommandDecoder.Unwritten &&
      (banks(bank)(layout.vertexWords * v + 3) >> 25) == tag
    }
    if (!sent) trianglesRefused += 1
    else {
      val xy = corners.map(v => banks(bank)(layout.vertexWords * v))
      TriangleBox(config, xy.map(w => (w >> 16).toShort.toInt), xy.map(_.toShort.toInt)).foreach { box =>
        if (stored == config.maxTriangles) trianglesRefused += 1
        else {
          val at = layout.triangles + layout.triangleWords * stored
          banks(bank)(at) = indices
          banks(bank)(at + 1) = state.toLong << 28 | box.x0 << 15 | box.x1 << 10 | box.y0 << 5 | box.y1
          stored += 1
        }
      }
    }
  }

  /** In units of 16 texels; what does not fit the memory is not written. */
  private def writeTexels(address: Int, data: Seq[Int]): Boolean = {
    val first = address * 16
    for ((d, i) <- data.zipWithIndex if first + i < config.textureTexels) texels(first + i) = d
    first + data.length <= config.textureTexels
  }

  private def draw(sentVertices: Int, sentTriangles: Int): Unit = {
    if (sentVertices != vertices || sentTriangles != triangles) incomplete += 1
    jobs += Job(bank, stored, clearColor, region, banks(bank).toIndexedSeq)
    bank = 1 - bank
    open = false
  }
}

object CommandDecoder {
  val Unwritten: Long = -1
}
