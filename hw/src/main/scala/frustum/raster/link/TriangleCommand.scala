package frustum.raster.link

import frustum.contract.raster.{RasterConfig, RenderState, StoreLayout, StoredTriangle, StoredVertex}
import frustum.raster.store.FieldBits
import frustum.raster.store.FieldBits._
import spinal.core._
import spinal.lib._

/** Executes `triangles`: reads the tags and positions of a triangle's corners, and writes the triangle if its corners
  * and its render state belong to the frame and something of it is on the screen. About 50 cycles a triangle, in which
  * [[SentStates]] finds the state before its result is used.
  *
  * The corners are read last corner first, see [[TriangleAssembly]]; `turn` moves the next corner's index to the place
  * of the last one.
  */
case class TriangleCommand(config: RasterConfig) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val up = slave(GroupPort())
    val turn = out Bool ()
    val index = in UInt (log2Up(RenderState.Count) bits)
    val missing, sent = in Bool () // see SentStates
    val tag = in Bits (StoredVertex.Tag.width bits)
    val fresh = in Bool () // no triangle of the frame has arrived yet
    val reads = master(Stream(UInt(layout.bankAddressBits bits)))
    val answer = slave(Flow(Bits(32 bits)))
    val writes = master(Stream(StoreWrite(layout)))
    val arrived = out(Reg(UInt(CommandDecoder.CountBits bits)))
    val stored = out(Reg(UInt(config.countBits bits))) // triangles in the bank
    val refused = out Bool ()
  }
  object State extends SpinalEnum(binaryOneHot) {
    val idle, read, response, settle, axisDone, indices, box = newElement()
  }
  val state = RegInit(State.idle)
  val group = io.up.group
  val corner = StoredTriangle.V2.in(group.words).asUInt
  val full = RegNext(if (isPow2(config.maxTriangles)) io.stored.msb else io.stored === config.maxTriangles)
  val triangle = new TriangleAssembly(config, io.tag, corner, io.answer.payload, state === State.response)
  val refused = triangle.stale || !io.sent || (!triangle.nothing && full)
  val done = False // the current triangle is done

  io.reads.valid := state === State.read
  io.reads.payload := StoreAddress.vertex(layout, corner, triangle.word)
  io.writes.valid := state === State.indices || state === State.box
  io.writes.address := StoreAddress.triangle(layout, io.stored, (state === State.box).asUInt)
  io.writes.data := group.words
  when(state === State.box) {
    StoredTriangle.State.put(io.writes.data, io.index.asBits)
    FieldBits.putAll(StoredTriangle.box, io.writes.data, triangle.boxBits)
  }
  io.turn := False
  io.refused := False
  io.up.refuse := group.first && io.missing
  group.ready := group.first || done

  when(io.fresh) {
    io.arrived := 0
    io.stored := 0
  }
  switch(state) {
    is(State.idle) {
      triangle.start()
      when(group.valid && !group.first)(state := State.read)
    }
    is(State.read)(when(io.reads.ready)(state := State.response))
    is(State.response) {
      triangle.answer()
      io.turn := triangle.cornerDone
      state := Mux(triangle.cornerDone && triangle.lastCorner, State.settle(), State.read())
    }
    is(State.settle)(when(triangle.settle())(state := State.axisDone))
    is(State.axisDone) {
      when(!triangle.vertical) {
        triangle.turnVertical()
        state := State.read
      } otherwise {
        io.arrived := io.arrived + 1
        io.refused := refused
        state := State.indices
        when(refused || triangle.nothing)(done := True)
      }
    }
    is(State.indices)(when(io.writes.ready)(state := State.box))
    is(State.box)(when(io.writes.ready) {
      io.stored := io.stored + 1
      done := True
    })
  }
  when(done)(state := State.idle)
}
