package frustum.raster.link

import frustum.contract.raster.{RasterConfig, StoredVertex, VerticesHeadLayout}
import frustum.raster.store.FieldBits._
import spinal.core._
import spinal.lib._

/** A word of a vertex for the store; a vertex's words follow one another. */
case class VertexWord(config: RasterConfig) extends Bundle {
  val index = UInt(config.vertexBits bits)
  val word = UInt(log2Up(StoredVertex.words) bits)
  val data = Bits(32 bits)
  val beyond = Bool() // there is no vertex of this index
  val fault = Bool() // so far a number of the vertex is out of range
}

/** Executes `vertices`: numbers the vertices and checks their ranges as they pass. */
case class VertexCommand(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(GroupPort())
    val passing = slave(Flow(Bits(16 bits))) // the words of the command
    val down = master(Stream(VertexWord(config)))
    val fresh = in Bool () // no vertex of the frame has arrived yet
    val arrived = out(Reg(UInt(CommandDecoder.CountBits bits)))
    val refused = out Bool ()
  }
  val group = io.up.group
  val index = Reg(UInt(config.vertexBits bits))
  val beyond = Reg(Bool())
  val word = Reg(UInt(log2Up(StoredVertex.words) bits))
  val last = word === StoredVertex.words - 1

  val check = VertexCheck(config.ranges)
  check.io.word << io.passing
  check.io.pair := word
  check.io.second := group.valid
  check.io.clear := group.valid && group.first

  io.down.valid := group.valid && !group.first && !check.io.busy
  io.down.index := index
  io.down.word := word
  io.down.data := group.words
  io.down.beyond := beyond
  io.down.fault := check.io.fault
  group.ready := group.first || io.down.ready && !check.io.busy
  io.up.refuse := False
  io.refused := io.down.fire && last && (beyond || check.io.fault)

  when(group.valid && group.first) {
    index := group.single.asUInt.resized
    beyond := VerticesHeadLayout.First.in(group.single).asUInt >= config.maxVertices
    word := 0
  }
  when(io.down.fire) {
    word := word + 1
    when(last) {
      word := 0
      index := index + 1
      beyond setWhen (index === config.maxVertices - 1)
      io.arrived := io.arrived + 1
      check.io.clear := True
    }
  }
  when(io.fresh)(io.arrived := 0)
}
