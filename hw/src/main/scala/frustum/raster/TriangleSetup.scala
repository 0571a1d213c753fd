package frustum.raster

import frustum.blackbox.Tech
import frustum.link.StoreBus
import frustum.spec.{RasterConfig, SetupInstruction, SetupProgram, SetupWords, StoreLayout}
import spinal.core._
import spinal.lib._

/** A triangle to be drawn in a tile, or the end of the tile. */
case class TileJob(config: RasterConfig) extends Bundle {
  val tileEnd  = Bool()
  val tileX    = UInt(5 bits)
  val tileY    = UInt(5 bits)
  val triangle = UInt(10 bits)
  val state    = UInt(4 bits)
}

/** Sets triangles up for the tiles they touch, one ahead of the interpolator.
  *
  * A triangle met for the first time in a frame is fetched and set up whole. It then keeps its slot until another
  * triangle takes it, so that in further tiles only the edge functions and the planes' first values are worked out.
  *
  * @param slots triangles kept
  */
case class TriangleSetup(config: RasterConfig, slots: Int, tech: Tech) extends Component {
  import SetupWords._
  require(slots >= 3 && slots <= 32, s"TriangleSetup: $slots slots; from 3 (two are drawn, one is set up) to 32")
  val layout = StoreLayout(config)
  val io = new Bundle {
    val flush = in Bool () // a new frame: the triangles kept are no more
    val bank  = in UInt (1 bits)
    val job   = slave Stream (TileJob(config))
    val store = master(StoreBus(layout))
    val write = master Flow (CoefficientWrite(slots))
    val spans = master Stream (Span(config))
    val token = master Stream (DrawToken(config, slots))
    val busy  = out Bool () // tokens are under way
    val setUp = out Bool () // pulses when a triangle has been set up whole
    val moved = out Bool () // pulses when a triangle has been moved to a tile
  }

  val engine = SetupEngine(slots, tech)
  val walker = EdgeWalker(config)
  val fetch  = SetupFetch(layout)
  val writer = CoefficientWriter(slots)
  val job    = io.job.payload
  val slot   = Reg(UInt(log2Up(slots) bits)) init 0
  val parity = Reg(Bool())
  engine.io.slot := slot
  fetch.io.triangle := job.triangle
  fetch.io.upper := False
  fetch.io.bank := io.bank
  fetch.io.store <> io.store
  fetch.io.readData := engine.io.readData
  walker.io.step << engine.io.step
  walker.io.edge.valid := engine.io.result.valid && engine.io.result.kind === SetupInstruction.Edge(0).code
  walker.io.edge.index := engine.io.result.target.resized
  walker.io.edge.value := engine.io.result.value
  writer.io.result << engine.io.result
  writer.io.slot := slot
  writer.io.parity := parity
  io.write << writer.io.write

  // The slots' triangles; the slot that was set up longest ago is taken next.
  val tags   = Vec.fill(slots)(Reg(UInt(10 bits)))
  val known  = Vec.fill(slots)(RegInit(False))
  val hits   = Vec(tags.zip(known).map { case (tag, valid) => valid && tag === job.triangle })
  val cached = hits.orR
  val next   = Reg(UInt(log2Up(slots) bits)) init 0
  when(io.flush) { known.foreach(_ := False) }

  // The token being drawn and the one after it. Their slots must not be set up anew meanwhile.
  val token   = Stream(DrawToken(config, slots))
  val waiting = token.halfPipe() // cuts the way of ready
  val drawn   = waiting.m2sPipe()
  def holds(s: Stream[DrawToken]) = s.valid && !s.tileEnd
  val nextUsed = Seq(waiting, drawn).map(s => holds(s) && s.slot === next).orR
  val bothUsed = holds(waiting) && holds(drawn) // so are both entries for first values
  io.token << drawn
  io.busy := waiting.valid || drawn.valid

  import SetupProgram.{SectionArea, SectionAttributes, SectionEdges, SectionGradients, SectionRebase, SectionSteps}

  // First span of the triangle; the walker's end mark counts only where there was one.
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

  // A power of two, for shifts by multiplication.
  val shift        = Reg(UInt(5 bits))
  val oneHotAmount = UInt(5 bits)
  oneHotAmount := fetch.io.write.valid ? fetch.io.scaleShift | shift
  val oneHot = (U(1, 32 bits) |<< oneHotAmount).asSInt

  // Between the engine's runs this control writes and reads the scratch memory.
  val sliver = Reg(Bool())
  walker.io.start := False
  engine.io.sliver := sliver
  engine.io.read := fetch.io.read
  engine.io.write << fetch.io.write
  when(fetch.io.scale) { engine.io.write.data := oneHot }
  def write(word: Int, data: SInt): Unit = {
    engine.io.write.valid := True
    engine.io.write.word := word
    engine.io.write.data := data
  }

  // The area, to be shifted left until bit 29 is set.
  val area     = Reg(UInt(30 bits))
  val backward = Reg(Bool()) // the triangle faces away
  when(engine.io.result.valid && engine.io.result.target === SetupWords.Area) {
    area := engine.io.result.value.asUInt.resized
    backward := engine.io.result.value.msb
  }

  // The tile's last column and row on the screen.
  private def lastIn(tile: UInt, log2: Int, size: Int) =
    (tile === ((size - 1) >> log2)) ? U((size - 1) & ((1 << log2) - 1), log2 bits) | U((1 << log2) - 1, log2 bits)
  val lastColumn = RegNext(lastIn(job.tileX, config.tileLog2Width, config.width))
  val lastRow    = RegNext(lastIn(job.tileY, config.tileLog2Height, config.height))
  walker.io.lastColumn := lastColumn
  walker.io.lastRow := lastRow

  // A pixel's position relative to vertex 0, whose coordinate was just read, in 1/16 pixel.
  val pixel = UInt(10 bits)
  def inTileX(x: UInt) = (job.tileX @@ x).resize(10)
  def inTileY(y: UInt) = (job.tileY @@ y).resize(10)
  pixel := inTileX(U(0, config.tileLog2Width bits))
  fetch.io.pixel := pixel
  val position = fetch.io.write.data

  object State extends SpinalEnum {
    val Idle, Fetch, Area, Facing, Normalise, WriteArea, WriteShift, WriteShift4, Check, ReadX,
      WriteLeft, WriteRight, WriteTop, Walk, Look, WritePixelX, WritePixelY, Hand, Run = newElement()
  }
  val state = RegInit(State.Idle)
  val after = Reg(State()) // where to go when the engine is idle again
  val started = Reg(Bool())
  engine.io.run.valid := False
  engine.io.run.payload := 0
  def run(section: Int, next: State.E): Unit = {
    engine.io.run.valid := True
    engine.io.run.payload := section
    after := next
    state := State.Run
    started := False
  }

  io.job.ready := False
  io.setUp := False
  io.moved := False
  fetch.io.start := False

  switch(state) {
    is(State.Idle) {
      sliver := False
      shift := 0
      when(io.job.valid) {
        when(job.tileEnd) {
          token.valid := True
          io.job.ready := token.ready
        } elsewhen (cached) {
          slot := OHToUInt(hits)
          state := State.ReadX
        } elsewhen (!nextUsed) {
          slot := next
          next := (next === slots - 1) ? U(0) | next + 1
          known(next) := False
          fetch.io.start := True
          state := State.Fetch
        }
      }
    }
    is(State.Fetch) { when(fetch.io.done) { state := State.Area } }
    is(State.Area) { run(SectionArea, State.Facing) }
    is(State.Facing) {
      state := State.Normalise
      when(backward || area === 0) {
        io.job.ready := True
        state := State.Idle
      }
    }
    is(State.Normalise) {
      when(area.msb || shift === MaxShift) {
        state := State.WriteArea
      } otherwise {
        area := area |<< 1
        shift := shift + 1
      }
    }
    is(State.WriteArea) { write(AreaNormal, (area | (1 << 29) | 1).intoSInt.resize(32)); state := State.WriteShift }
    is(State.WriteShift) { write(Shift, oneHot); state := State.WriteShift4 }
    is(State.WriteShift4) {
      oneHotAmount := sliver ? (shift - 10) | (shift + 4)
      write(Shift4, oneHot)
      when(sliver) { run(SectionSteps, State.Check) } otherwise { run(SectionAttributes, State.Check) }
    }
    is(State.Check) {
      when(engine.io.overflow && !sliver) {
        sliver := True
        state := State.WriteShift4
      } otherwise {
        known(slot) := True
        tags(slot) := job.triangle
        io.setUp := True
        run(SectionGradients, State.ReadX)
      }
    }

    is(State.ReadX) { engine.io.read := X0; state := State.WriteLeft }
    is(State.WriteLeft) { engine.io.read := X0; write(Left, position); state := State.WriteRight }
    is(State.WriteRight) {
      engine.io.read := Y0
      pixel := inTileX(lastColumn)
      write(Right, position)
      state := State.WriteTop
    }
    is(State.WriteTop) {
      engine.io.read := Y0
      pixel := inTileY(U(0, config.tileLog2Height bits))
      write(Top, position)
      when(walker.io.idle) { run(SectionEdges, State.Walk) }
    }
    is(State.Walk) { walker.io.start := True; seen := False; state := State.Look }
    is(State.Look) {
      engine.io.read := X0
      when(seen) { when(!bothUsed) { state := State.WritePixelX } } elsewhen (walker.io.up.valid) {
        // the end mark, without a span before it
        when(walker.io.up.end) { io.job.ready := True; state := State.Idle }
      }
    }
    is(State.WritePixelX) {
      engine.io.read := Y0
      pixel := inTileX(firstX)
      fetch.io.upper := True
      write(PixelX_16, position)
      state := State.WritePixelY
    }
    is(State.WritePixelY) {
      pixel := inTileY(firstY)
      fetch.io.upper := True
      write(PixelY_16, position)
      run(SectionRebase, State.Hand)
    }
    is(State.Hand) {
      token.valid := True
      when(token.ready) {
        parity := !parity
        io.job.ready := True
        io.moved := True
        state := State.Idle
      }
    }
    is(State.Run) {
      started := True
      when(started && engine.io.idle) { state := after }
    }
  }
}
