package frustum.raster

import frustum.blackbox.Tech
import frustum.link.StoreBus
import frustum.spec.{Domain, RasterConfig, SetupInstruction, SetupProgram, SetupWords, StoreLayout}
import spinal.core._
import spinal.lib._

/** A triangle to be drawn in a tile, or the end of the tile. */
case class TileJob(config: RasterConfig) extends Bundle {
  val tileEnd  = Bool()
  val tileX    = UInt(5 bits)
  val tileY    = UInt(5 bits)
  val triangle = UInt(10 bits)
  val state    = UInt(4 bits)
  val vertices = Vec(UInt(10 bits), 3)
}

/** Sets triangles up for the tiles they touch, one ahead of the interpolator.
  *
  * A triangle met for the first time in a frame is fetched and set up whole. It then keeps its slot until another
  * triangle takes it, so that in further tiles only the edge functions and the planes' first values are worked out.
  *
  * @param slots triangles kept, a power of two
  */
case class TriangleSetup(config: RasterConfig, slots: Int, tech: Tech) extends Component {
  import SetupWords._
  require(isPow2(slots) && slots >= 2 && slots <= 32, s"TriangleSetup: $slots slots; a power of two from 2 to 32")
  val layout = StoreLayout(config)
  val io = new Bundle {
    val flush = in Bool () // a new frame: the triangles kept are no more
    val bank  = in UInt (1 bits)
    val job   = slave Stream (TileJob(config))
    val store = master(StoreBus(layout))
    val write = master Flow (CoefficientWrite(slots))
    val spans = master Stream (Span(config))
    val token = master Stream (DrawToken(config, slots))
    val busy  = out Bool () // a triangle or a tile's end has not been drawn yet
    val setUp = out Bool () // pulses when a triangle has been set up whole
    val moved = out Bool () // pulses when a triangle has been moved to a tile
  }

  val engine = SetupEngine(slots, tech)
  val walker = EdgeWalker(config)
  val fetch  = SetupFetch(layout)
  val writer = CoefficientWriter(slots)
  val job    = io.job.payload
  val slot   = job.triangle.resize(log2Up(slots))
  val parity = Reg(Bool())
  engine.io.slot := slot
  fetch.io.vertices := job.vertices
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

  val tags   = Vec.fill(slots)(Reg(UInt(10 bits)))
  val known  = Vec.fill(slots)(RegInit(False))
  val cached = known(slot) && tags(slot) === job.triangle
  when(io.flush) { known.foreach(_ := False) }

  // The triangle that is being drawn. Its slot must not be set up anew meanwhile.
  val token     = Stream(DrawToken(config, slots))
  val drawn     = Stream(DrawToken(config, slots))
  val slotDrawn = drawn.valid && !drawn.tileEnd && drawn.slot === slot
  io.token << drawn

  // A tile's end waits behind the triangle that is being drawn, so that meanwhile the next tile's first can be set up.
  val endWaits = RegInit(False)
  val next     = Stream(DrawToken(config, slots))
  next.valid   := endWaits || token.valid && !token.tileEnd
  next.payload := token.payload
  next.tileEnd.removeAssignments() := endWaits
  token.ready  := !endWaits && (token.tileEnd || next.ready)
  when(next.fire) { endWaits := False }
  when(token.fire && token.tileEnd) { endWaits := True }
  drawn << next.m2sPipe(holdPayload = true)
  io.busy := endWaits || drawn.valid

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

  // The area, shifted left until bit 29 is set.
  val area = Reg(SInt(32 bits))
  when(engine.io.result.valid && engine.io.result.target === SetupWords.Area) { area := engine.io.result.value }

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
  val position = ((pixel << 4).intoSInt.resize(17) - engine.io.readData.resize(17)).resize(32)

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
          state := State.ReadX
        } elsewhen (!slotDrawn) {
          known(slot) := False
          fetch.io.start := True
          state := State.Fetch
        }
      }
    }
    is(State.Fetch) { when(fetch.io.done) { state := State.Area } }
    is(State.Area) { run(SectionArea, State.Facing) }
    is(State.Facing) {
      state := State.Normalise
      when(area < Domain.MinArea) { area := Domain.MinArea }
      when(area <= 0) {
        io.job.ready := True
        state := State.Idle
      }
    }
    is(State.Normalise) {
      when(area(29)) {
        state := State.WriteArea
      } elsewhen (area(29 downto 26) === 0) {
        area := area |<< 4
        shift := shift + 4
      } otherwise {
        area := area |<< 1
        shift := shift + 1
      }
    }
    is(State.WriteArea) { write(AreaNormal, area | 1); state := State.WriteShift }
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
      when(seen) { state := State.WritePixelX } elsewhen (walker.io.up.valid) {
        // the end mark, without a span before it
        when(walker.io.up.end) { io.job.ready := True; state := State.Idle }
      }
    }
    is(State.WritePixelX) {
      engine.io.read := Y0
      pixel := inTileX(firstX)
      write(PixelX_16, position |<< 16)
      state := State.WritePixelY
    }
    is(State.WritePixelY) {
      pixel := inTileY(firstY)
      write(PixelY_16, position |<< 16)
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
