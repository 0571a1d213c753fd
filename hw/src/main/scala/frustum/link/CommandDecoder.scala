package frustum.link

import frustum.texture.TexelWrite
import frustum.spec.Command
import frustum.spec.PackedVertex
import frustum.spec.RasterConfig
import frustum.spec.StoreLayout
import spinal.core._
import spinal.lib._

/** What the decoder did, one-clock pulses; what they mean is told in [[LinkStatus]]. */
case class DecoderEvents() extends Bundle {
  val accepted, refused, vertexRefused, triangleRefused, incomplete = Bool()
}

/** Executes checked commands, see [[frustum.spec.Command]], one at a time and a word a clock at most.
  *
  *   - `words`: as [[Framer]] delivers them: `opcode << 8 | length`, then the payload. Opcodes and lengths are not
  *     checked again.
  *   - `job`: a filled bank; waits until the rasterizer takes it. Banks alternate; `jobDone` pulses when the oldest
  *     job's bank is free again. `begin` waits for a free bank, `texels` until every job is done.
  *   - a refused command changes nothing, but for texels that run beyond the memory, of which those within it are
  *     written, and for `begin`, which ends the frame begun before it in any case
  *   - a refused vertex leaves its slot with a tag of another frame, its position untouched, so whatever lies in the
  *     store is within the accepted range
  *   - a triangle costs about 35 clocks, a vertex 16
  */
case class CommandDecoder(config: RasterConfig) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val words   = slave(Stream(Bits(16 bits)))
    val store   = master(StoreBus(layout))
    val texels  = master(Stream(TexelWrite()))
    val job     = master(Stream(FrameJob()))
    val jobDone = in Bool ()
    val drawing = out Bool ()
    val events  = out(DecoderEvents())
  }
  import DecoderState._

  val state   = RegInit(header)
  val opcode  = Reg(UInt(3 bits))
  val left    = Reg(UInt(7 bits)) // payload words still to come
  val refused = Reg(Bool())
  val data    = Reg(Bits(32 bits)) // the last two words
  def is_(command: Command): Bool = opcode === command.opcode

  // The frame being filled.
  val open         = RegInit(False)
  val bank         = RegInit(False)
  val tag          = Reg(Bits(7 bits))
  val clearColor   = Reg(Bits(16 bits))
  val region       = Reg(Vec.fill(4)(UInt(5 bits))) // y1, y0, x1, x0
  val vertices     = Reg(UInt(CommandDecoder.CountBits bits)) // that arrived
  val triangles    = Reg(UInt(CommandDecoder.CountBits bits)) // that arrived
  val stored       = Reg(UInt(11 bits)) // triangles in the bank
  val triangleState = Reg(Bits(4 bits))

  // Jobs not yet done: at most two, as many as there are banks.
  val jobs = RegInit(U(0, 2 bits))
  io.drawing := jobs =/= 0
  jobs := jobs + U(io.job.fire) - U(io.jobDone)

  val take = False // the word in hand is payload and is used up
  val word = io.words.payload
  io.words.ready := take || state === header
  val took   = take && io.words.valid
  val rotate = False // the next corner's index moves down
  when(took)(left := left - 1)
  when(took || rotate) {
    data := Mux(rotate, data(31 downto 30) ## data(9 downto 0) ## data(29 downto 10), data(15 downto 0) ## word)
  }
  def after(next: SpinalEnumElement[DecoderState.type]): Unit = { take := True; when(io.words.valid)(state := next) }

  io.events.accepted        := state === finish && !refused
  io.events.refused         := state === finish && refused
  io.events.vertexRefused   := False
  io.events.triangleRefused := False
  io.events.incomplete      := False

  // Address of a vertex's word or a texel; counts up as words are written.
  val address  = Reg(UInt(16 bits))
  val count    = False
  val tagRead  = Reg(Bool())
  val vertexAddress = ((data(9 downto 0) ## tagRead ## tagRead).asUInt +^ data(9 downto 0).asUInt).resize(16)
  val texelAddressed = (data(10 downto 0) << 4).asUInt.resize(16)
  when(count || state === loadVertex || state === load || state === loadTexel) {
    address := Mux(count, address + 1, Mux(is_(Command.Texels), texelAddressed, vertexAddress))
  }
  val beyond   = Reg(Bool()) // the vertex index is

  val check = VertexCheck()
  val pair  = Reg(UInt(3 bits))
  check.io.clear        := False
  check.io.word.valid   := took && is_(Command.Vertices) && (state === fetchFirst || state === fetchSecond)
  check.io.word.payload := word
  check.io.pair         := pair
  check.io.second       := state === fetchSecond

  val box      = TriangleBox(config)
  val vertical = Reg(Bool())
  val corner   = Reg(UInt(2 bits))
  val stale    = Reg(Bool()) // a corner was not sent in this frame
  val missed   = Reg(Bool()) // the screen, horizontally
  val firstX, lastX = Reg(UInt(5 bits))
  val xy = io.store.rsp.payload
  box.io.clear              := False
  box.io.vertical           := vertical
  box.io.coordinate.valid   := state === response && !tagRead
  box.io.coordinate.payload := Mux(vertical, xy(14 downto 0), xy(30 downto 16)).asSInt

  val boxWord = triangleState ## data(27 downto 20) ## firstX ## lastX ## box.io.firstY ## box.io.lastY
  io.store.cmd.valid   := False
  io.store.cmd.write   := state =/= read
  val second      = state === writeBox
  val placeBits   = layout.bankAddressBits
  val place       = UInt(placeBits bits)
  place := address.resized
  when(state === writeIndices || second)(place := layout.triangles + (stored ## second).asUInt.resize(placeBits))
  when(state === writeState)(place := layout.states + triangleState.asUInt.resize(placeBits))
  io.store.cmd.address := bank.asUInt @@ place
  io.store.cmd.data    := data
  when(second)(io.store.cmd.data := boxWord)
  when(state === writeVertex && pair === 3)(io.store.cmd.data(31 downto 25) := tag ^ (check.io.fault ## B(0, 6 bits)))

  val texelFits = address < config.textureTexels
  io.texels.valid   := state === texel && left =/= 0 && io.words.valid && texelFits
  io.texels.address := address.resized
  io.texels.data    := word

  io.job.valid         := state === hand
  io.job.bank          := bank.asUInt
  io.job.triangleCount := stored
  io.job.clearColor    := clearColor
  io.job.y1            := region(0)
  io.job.y0            := region(1)
  io.job.x1            := region(2)
  io.job.x0            := region(3)

  val (first, last) = (word(12 downto 8).asUInt, word(4 downto 0).asUInt)
  val tiles    = Mux(state === regionX, U(config.tilesX - 1, 5 bits), U(config.tilesY - 1, 5 bits))
  val badRange = (word & 0xe0e0) =/= 0 || first > last || last > tiles
  def refuseIf(condition: Bool): Unit = when(condition && io.words.valid)(refused := True)
  def nextGroup(): Unit = state := Mux(left === 0, finish(), fetchFirst())

  switch(state) {
    is(header) {
      opcode  := word(10 downto 8).asUInt
      left    := word(6 downto 0).asUInt
      refused := False
      beyond  := False
      tagRead := False
      pair    := 0
      check.io.clear := True
      when(io.words.valid)(state := dispatch)
    }
    is(dispatch) {
      switch(opcode) {
        is(Command.Begin.opcode)(state := begin)
        is(Command.State.opcode)(state := stateIndex)
        is(Command.Vertices.opcode)(state := firstVertex)
        is(Command.Triangles.opcode)(state := commonState)
        is(Command.Texels.opcode)(state := texelAddress)
        is(Command.Draw.opcode)(state := drawVertices)
        default { refused := True; state := skip }
      }
      when(!open && !is_(Command.Begin) && !is_(Command.Texels)) { refused := True; state := skip }
    }
    is(skip) {
      take := left =/= 0
      when(left === 0)(state := finish)
    }
    is(finish) {
      when(is_(Command.Begin))(open := !refused)
      state := header
    }

    is(begin) {
      open      := False
      vertices  := 0
      triangles := 0
      stored    := 0
      when(!jobs.msb)(state := frame)
    }
    is(frame) { tag := word(6 downto 0); after(color) }
    is(color) { clearColor := word; after(regionX) }
    is(regionX) { refuseIf(badRange); after(regionY) }
    is(regionY) { refuseIf(badRange); after(finish) }

    is(stateIndex, commonState) {
      triangleState := word(3 downto 0)
      val bad = word(15 downto 4) =/= 0
      refuseIf(bad)
      take := True
      when(io.words.valid)(state := Mux(bad, skip(), fetchFirst()))
    }
    is(firstVertex)(after(loadVertex))
    is(loadVertex) {
      beyond := data(15 downto 0).asUInt >= config.maxVertices
      state  := fetchFirst
    }

    is(fetchFirst)(after(fetchSecond))
    is(fetchSecond) {
      take     := True
      vertical := False
      corner   := 0
      stale    := False
      box.io.clear := True
      when(io.words.valid) {
        state := load
        when(is_(Command.Vertices))(state := writeVertex)
        when(is_(Command.State))(state := writeState)
      }
    }
    is(writeState) {
      io.store.cmd.valid := True
      when(io.store.cmd.ready)(state := finish)
    }
    is(writeVertex) {
      val write = !beyond && (!check.io.fault || pair === 3)
      io.store.cmd.valid := write
      when(!write || io.store.cmd.ready) {
        count := True
        pair  := pair + 1
        state := fetchFirst
        when(pair === PackedVertex.WireWords / 2 - 1) {
          pair     := 0
          vertices := vertices + 1
          beyond setWhen (address === layout.triangles - 1)
          io.events.vertexRefused := check.io.fault || beyond
          check.io.clear          := True
          nextGroup()
        }
      }
    }

    is(load)(state := read)
    is(read) {
      io.store.cmd.valid := True
      when(io.store.cmd.ready)(state := response)
      if (config.maxVertices < 1024) stale setWhen (address >= layout.triangles)
    }
    is(response) {
      // Horizontally a corner's x and its tag are read, vertically its y.
      tagRead := !vertical && !tagRead
      state   := load
      when(tagRead || vertical) {
        rotate := True
        corner := corner + 1
        when(corner === 2)(state := settle)
      }
      when(tagRead && xy(31 downto 25) =/= tag)(stale := True)
    }
    is(settle) {
      corner := corner + 1 // 3, 0, 1: three clocks
      when(corner === 1)(state := axisDone)
    }
    is(axisDone) {
      corner   := 0
      vertical := True
      when(!vertical) {
        box.io.clear := True
        missed       := box.io.empty
        firstX       := box.io.firstX
        lastX        := box.io.lastX
        state        := load
      } otherwise {
        triangles := triangles + 1
        val nothing = missed || box.io.empty
        val refuse  = stale || (!nothing && stored === config.maxTriangles)
        io.events.triangleRefused := refuse
        when(refuse || nothing)(nextGroup()) otherwise (state := writeIndices)
      }
    }
    is(writeIndices) {
      io.store.cmd.valid := True
      when(io.store.cmd.ready)(state := writeBox)
    }
    is(writeBox) {
      io.store.cmd.valid := True
      when(io.store.cmd.ready) { stored := stored + 1; nextGroup() }
    }

    is(texelAddress)(after(loadTexel))
    is(loadTexel) {
      when(data(15 downto 11) =/= 0) { // also keeps the address from wrapping
        refused := True
        state   := skip
      } elsewhen (jobs === 0)(state := texel)
    }
    is(texel) {
      when(left === 0)(state := finish) otherwise {
        take := io.texels.ready || !texelFits
        when(io.words.valid && !texelFits)(refused := True)
        count := took
      }
    }

    is(drawVertices) { stale := word.asUInt =/= vertices.resize(16); after(drawTriangles) }
    is(drawTriangles) {
      when(word.asUInt =/= triangles.resize(16))(stale := True)
      after(hand)
    }
    is(hand) {
      when(io.job.ready) {
        io.events.incomplete := stale
        open  := False
        bank  := !bank
        state := finish
      }
    }
  }

  // Region words come last in `begin`: they move through as through a shift register.
  when(took && (state === regionX || state === regionY)) {
    region(3) := region(1)
    region(2) := region(0)
    region(1) := word(12 downto 8).asUInt
    region(0) := word(4 downto 0).asUInt
  }
}

object CommandDecoder {
  /** Vertices and triangles that arrive are counted modulo 4096, to be compared with what `draw` says was sent. */
  val CountBits = 12
}
