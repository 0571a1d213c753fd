package frustum.raster.setup

import frustum.contract.raster.{FetchProgram, RasterConfig, SetupInstruction, SetupProgram, SetupWords, StoreLayout}
import frustum.device.Tech
import frustum.raster.scan.{CoefficientWrite, DrawToken, EdgeWalker, Span, TileJob, TokenQueue}
import frustum.raster.store.StoreBus
import spinal.core._
import spinal.lib._

/** Sets triangles up for the tiles they touch, ahead of the interpolator by two.
  *
  * A triangle is fetched and set up completely where it first occurs in a frame. It keeps its slot until another one
  * takes it, so that in further tiles only the edge functions and the planes' first values are computed.
  */
case class TriangleSetup(config: RasterConfig, tech: Tech = Tech.Generic) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val flush = in Bool () // a new frame: no triangle is kept
    val bank = in UInt (1 bits)
    val job = slave(Stream(TileJob(config)))
    val store = master(StoreBus(layout))
    val write = master(Flow(CoefficientWrite(config.slots)))
    val spans = master(Stream(Span(config)))
    val token = master(Stream(DrawToken(config)))
    val busy = out Bool () // jobs or tokens are in flight
    val setUp = out Bool () // pulses when a triangle has been set up completely
    val moved = out Bool () // pulses when a triangle has been moved to a tile
    val undrawn = out Bool () // pulses once for each triangle of the frame that faces away or has no area
  }

  val lookup = SlotLookup(config)
  val engine = SetupEngine(config.slots, tech, config.fixed.planes)
  val walker = EdgeWalker(config)
  val fetch = SetupFetch(config, config.slots, config.fixed.planes)
  val writer = CoefficientWriter(config.slots)

  lookup.io.flush := io.flush
  lookup.io.up << io.job
  lookup.io.tags <> fetch.io.spare
  val found = lookup.io.down.halfPipe()
  val slot = found.slot
  val job = found.job

  val parity = Reg(Bool())
  engine.io.slot := slot
  engine.io.read := fetch.io.read
  engine.io.write << fetch.io.write
  fetch.io.triangle := job.triangle
  fetch.io.bank := io.bank
  fetch.io.store <> io.store
  fetch.io.readData := engine.io.readData
  val result = engine.io.result
  walker.io.step << engine.io.step
  val isEdge = result.valid && result.kind === SetupInstruction.Edge(0).code
  val atFar = result.target(2) // the edge function where it is largest in the tile
  val outside = RegInit(False) setWhen (isEdge && atFar && result.value.msb) // all of the tile is outside an edge
  walker.io.edge.valid := isEdge && !atFar
  walker.io.edge.index := result.target.resized
  walker.io.edge.value := result.value
  writer.io.result << result
  writer.io.slot := slot
  writer.io.parity := parity
  io.write << writer.io.write

  val tokens = TokenQueue(config)
  val token = tokens.io.up
  tokens.io.slot := slot
  tokens.io.down >> io.token
  io.busy := io.job.valid || found.valid || tokens.io.busy

  // First span of the triangle; the walker's end marker counts only where there was one.
  val seen = RegInit(False)
  val firstX = RegNextWhen(walker.io.up.first, !seen)
  val firstY = RegNextWhen(walker.io.up.y, !seen)
  seen.setWhen(walker.io.up.valid && !walker.io.up.end)
  io.spans << walker.io.up.throwWhen(walker.io.up.end && !seen)

  token.valid := False
  token.tileEnd := job.tileEnd
  token.state := job.state
  token.slot := slot
  token.parity := parity
  token.x := firstX

  val area = new TriangleArea(result, engine.memory.code(SetupWords.Area))
  engine.io.sliver := area.sliver
  val empty = Vec.fill(config.slots)(Reg(Bool())) // the slot's triangle draws nothing
  val isEmpty = RegNext(empty(slot))

  // The tile's last column and row on the screen.
  private def lastIn(tile: UInt, log2: Int, size: Int) =
    Mux(tile === ((size - 1) >> log2), U((size - 1) & ((1 << log2) - 1), log2 bits), U((1 << log2) - 1, log2 bits))
  val lastColumn = RegNext(lastIn(job.tileX, config.tileLog2Width, config.width))
  val lastRow = RegNext(lastIn(job.tileY, config.tileLog2Height, config.height))
  walker.io.lastColumn := lastColumn
  walker.io.firstRow := 0
  walker.io.lastRow := lastRow

  val values = fetch.io.values
  values.tileX := job.tileX
  values.tileY := job.tileY
  values.lastColumn := lastColumn
  values.lastRow := lastRow
  values.coveredX := firstX
  values.coveredY := firstY
  values.area := area.value
  values.place := area.place

  import SetupProgram.{SectionArea, SectionAttributes, SectionEdges, SectionGradients, SectionRebase, SectionSteps}
  object State extends SpinalEnum(binaryOneHot) {
    val Idle, Begin, Area, Facing, Normalise, GradientShift, Attributes, Check, Gradients, Corner, Edges, Walk, Look,
        Pixel, Rebase, Hand = newElement()
  }
  val state = RegInit(State.Idle)
  val busy = RegInit(False) // engine or fetch are busy; `state` is what follows
  engine.io.run.valid := False
  engine.io.run.payload.assignDontCare()
  fetch.io.start := False
  fetch.io.program.assignDontCare()
  def run(section: Int, next: State.E): Unit = {
    engine.io.run.valid := True
    engine.io.run.payload := section
    busy := True
    state := next
  }
  def load(program: Int, next: State.E): Unit = {
    fetch.io.start := True
    fetch.io.program := program
    busy := True
    state := next
  }

  val finished = RegInit(False) // the current job leaves, a cycle after it is done
  finished := False
  found.ready := finished
  def finish(): Unit = {
    finished := True
    state := State.Idle
  }

  Seq(io.setUp, io.undrawn).foreach(_ := False)
  val moved = False
  io.moved := RegNext(moved, False) // as the job leaves
  walker.io.start := False

  when(busy) {
    busy := !engine.io.idle || !fetch.io.idle
  } otherwise {
    switch(state) {
      is(State.Idle) {
        area.start()
        when(found.valid && !finished) { state := State.Begin }
      }
      is(State.Begin) {
        when(job.tileEnd) {
          token.valid := True
          when(token.ready) { finish() }
        } elsewhen (found.known) {
          state := State.Corner
          when(isEmpty) { finish() }
        } elsewhen (!tokens.io.slotUsed) {
          load(0, State.Area)
        }
      }
      is(State.Area) { run(SectionArea, State.Facing) }
      is(State.Facing) {
        state := State.Normalise
        empty(slot) := area.nothing
        when(area.nothing) {
          io.undrawn := job.first
          finish()
        }
      }
      is(State.Normalise) {
        when(area.normal) { load(FetchProgram.Normal, State.GradientShift) } otherwise { area.shift() }
      }
      is(State.GradientShift) { area.toGradients(); load(FetchProgram.GradientShift, State.Attributes) }
      is(State.Attributes) {
        when(area.sliver) { run(SectionSteps, State.Check) } otherwise { run(SectionAttributes, State.Check) }
      }
      is(State.Check) {
        when(engine.io.overflow && !area.sliver) {
          area.sliver := True
          state := State.GradientShift
        } otherwise {
          state := State.Gradients
        }
      }
      is(State.Gradients) {
        io.setUp := True
        run(SectionGradients, State.Corner)
      }
      is(State.Corner) { outside := False; load(FetchProgram.Corner, State.Edges) }
      is(State.Edges) { when(walker.io.idle) { run(SectionEdges, State.Walk) } }
      is(State.Walk) {
        walker.io.start := !outside
        seen := False
        state := State.Look
        when(outside) { finish() }
      }
      is(State.Look) {
        when(seen) {
          when(!tokens.io.full) { state := State.Pixel }
        } elsewhen (walker.io.up.valid && walker.io.up.end) {
          finish() // no span before the end marker
        }
      }
      is(State.Pixel) { load(FetchProgram.Pixel, State.Rebase) }
      is(State.Rebase) { run(SectionRebase, State.Hand) }
      is(State.Hand) {
        token.valid := True
        when(token.ready) {
          parity := !parity
          moved := True
          finish()
        }
      }
    }
  }
}
