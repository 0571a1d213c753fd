package frustum.model.raster.link

import frustum.contract.raster.{
  BeginLayout,
  Command,
  PackedTriangle,
  PackedVertex,
  RasterConfig,
  RenderState,
  StateHeadLayout,
  StoreLayout,
  StoredState,
  StoredStateLayout,
  StoredTriangle,
  StoredVertex,
  TexelsHeadLayout,
  TileRegion,
  TriangleLayout
}
import scala.collection.mutable.ArrayBuffer

/** A job as handed to the rasterizer, with a copy of its bank. */
final case class Job(bank: Int, triangleCount: Int, clearColor: Int, region: TileRegion, store: IndexedSeq[Long])

/** What a checked command does, see [[frustum.raster.link.CommandDecoder]]. Waiting is not modelled: it changes no
  * result.
  *
  * Words of a bank that were never written are [[CommandDecoder.Unwritten]], spare bits are 0.
  */
final class CommandDecoder(config: RasterConfig, stateLayout: StoredStateLayout = StoredState) {
  val layout = StoreLayout(config, stateLayout)
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
  private val sentStates = collection.mutable.Set.empty[Int]

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
    val Seq(x0, x1, y0, y1) = Seq(BeginLayout.X0, BeginLayout.X1, BeginLayout.Y0, BeginLayout.Y1).map(_.of(w))
    clearColor = BeginLayout.ClearColor.of(w)
    open = config.clearColor.forall(_ == clearColor) && x0 <= x1 && x1 < config.tilesX && y0 <= y1 && y1 < config.tilesY
    tag = BeginLayout.Frame.of(w) & StoredVertex.Tag.ones
    region = TileRegion(x0, y0, x1, y1)
    vertices = 0
    triangles = 0
    stored = 0
    sentStates.clear()
    open
  }

  private def writeState(w: Seq[Int]): Boolean = {
    val (index, state) = (StateHeadLayout.Index.of(w), w.drop(StateHeadLayout.words))
    val inRange = index < RenderState.Count && config.fixed.accepts(state, stateLayout.wire)
    if (inRange && !config.fixed.whole) store(pairs(state))(layout.state(index, _))
    if (inRange) sentStates += index
    inRange
  }

  /** Words of the wire in pairs, the first in the upper half. */
  private def pairs(w: Seq[Int]): IndexedSeq[Int] =
    w.grouped(2).map(p => p.head << 16 | p.lift(1).getOrElse(0)).toIndexedSeq

  private def store(words: Seq[Int])(address: Int => Int): Unit =
    for ((word, n) <- words.zipWithIndex) banks(bank)(address(n)) = word & 0xffffffffL

  private def writeVertices(first: Int, w: Seq[Int]): Unit =
    for ((v, i) <- w.grouped(PackedVertex.WireWords).zipWithIndex) {
      vertices = (vertices + 1) & 0xfff
      val index = first + i
      if (index >= config.maxVertices) verticesRefused += 1
      else writeVertex(index, v)
    }

  /** The words are checked as they come; from the first one out of range on nothing is written but a tag that differs.
    */
  private def writeVertex(index: Int, v: Seq[Int]): Unit = {
    val out = (0 until layout.vertexWords).map(p => outOfRange(v, 2 * p + 2))
    val otherTag = tag ^ (StoredVertex.Tag.ones + 1) / 2
    for ((pair, p) <- pairs(v).zipWithIndex) {
      val word = pair & StoredVertex.mask(p)
      def put(word: Int) = store(Seq(word))(_ => layout.vertex(index, p))
      if (p == CommandDecoder.tagWord) put(StoredVertex.Tag.into(word, if (out(p)) otherTag else tag))
      else if (!out(p)) put(word)
    }
    if (out.last) verticesRefused += 1
  }

  /** Whether the first `known` words of a vertex suffice to refuse it: what is not known is taken to be in range. */
  private def outOfRange(v: Seq[Int], known: Int): Boolean =
    PackedVertex.decode(v.take(known) ++ CommandDecoder.harmless.drop(known)).fault(config.ranges).isDefined

  private def writeTriangles(state: Int, w: Seq[Int]): Boolean = {
    val inRange = state < RenderState.Count
    if (inRange) w.grouped(TriangleLayout.words).foreach(t => writeTriangle(PackedTriangle.decode(state, t)))
    inRange
  }

  private def writeTriangle(t: PackedTriangle): Unit = {
    triangles = (triangles + 1) & 0xfff
    val corners = Seq(t.v0, t.v1, t.v2)
    def vertex(index: Int) = (0 until layout.vertexWords).map(w => banks(bank)(layout.vertex(index, w)))
    val sent = corners.forall { v =>
      v < config.maxVertices && vertex(v)(CommandDecoder.tagWord) != CommandDecoder.Unwritten &&
      StoredVertex.Tag.of(vertex(v).map(_.toInt)) == tag
    }
    if (!sent || !sentStates(t.state)) trianglesRefused += 1
    else {
      val words = corners.map(vertex(_).map(_.toInt))
      TriangleBox(config, words.map(StoredVertex.X.of), words.map(StoredVertex.Y.of)).foreach { box =>
        if (stored == config.maxTriangles) trianglesRefused += 1
        else {
          store(storedTriangle(t, box))(layout.triangle(stored, _))
          stored += 1
        }
      }
    }
  }

  private def storedTriangle(t: PackedTriangle, tiles: TileRegion): Seq[Int] = {
    import StoredTriangle._
    encode(
      V0 -> t.v0,
      V1 -> t.v1,
      V2 -> t.v2,
      State -> t.state,
      X0 -> tiles.x0,
      X1 -> tiles.x1,
      Y0 -> tiles.y0,
      Y1 -> tiles.y1
    )
  }

  /** What does not fit the memory is not written. */
  private def writeTexels(address: Int, data: Seq[Int]): Boolean = {
    val first = address * TexelsHeadLayout.Unit
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

  /** Of a vertex. */
  private val tagWord = StoredVertex.Tag.slice.word

  /** The words of a vertex that nothing is wrong with. */
  private val harmless = PackedVertex(0, 0, 0, 32768, 0, 0, 0, 0, 0, 0, 0).words
}
