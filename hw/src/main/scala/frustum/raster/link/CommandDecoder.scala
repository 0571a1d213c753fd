package frustum.raster.link

import frustum.contract.raster.{Command, FixedState, PackedVertex, RasterConfig, StoreLayout}
import frustum.raster.store.{FrameJob, StoreBus}
import frustum.raster.texture.TexelWrite
import spinal.core._
import spinal.lib._

/** Executes checked commands, see [[frustum.contract.raster.Command]], one at a time and a word a clock at most.
  *
  *   - `words`: as [[Framer]] delivers them: `opcode << 8 | length`, then the payload. Opcodes and lengths are not
  *     checked again.
  *   - `job`: a filled bank; waits until the rasterizer takes it. Banks alternate; `jobDone` pulses when the oldest
  *     job's bank is free again. `begin` waits for a free bank, `texels` until every job is done.
  *   - a refused command changes nothing, but for texels that run beyond the memory, of which those within it are
  *     written, and for `begin`, which ends the frame begun before it in any case
  *   - hardware made for fewer states, clear colours, vertices or triangles, or for nearer ranges refuses the others alike
  *   - a refused vertex leaves its slot with a tag of another frame; a position out of range is not stored
  *   - a triangle costs about 62 clocks, a vertex 31
  */
case class CommandDecoder(config: RasterConfig) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val words = slave(Stream(Bits(16 bits)))
    val store = master(StoreBus(layout))
    val texels = master(Stream(TexelWrite()))
    val job = master(Stream(FrameJob(config)))
    val jobDone = in Bool ()
    val drawing = out Bool ()
    val events = out(DecoderEvents())
  }
  import DecoderState._

  val state = RegInit(header)
  val opcode = Reg(UInt(3 bits))
  val left = Reg(UInt(7 bits)) // payload words still to come
  val none = Reg(Bool()) // are
  val refused = Reg(Bool())
  val data = Reg(Bits(32 bits)) // the last two words
  val word = io.words.payload
  def is_(command: Command): Bool = opcode === command.opcode

  val take = False // the word in hand is payload and is used up
  val took = take && io.words.valid
  val rotate = False // the next corner's index moves down
  io.words.ready := take || state === header
  when(took) {
    left := left - 1
    none := left === 1
  }
  // A word is judged a clock after it came, by what was found then.
  val judged = RegNext(!took)
  val high12 = RegNext(data(15 downto 4) =/= 0)
  val high5 = RegNext(data(15 downto 11) =/= 0)
  when(took || rotate) {
    data := Mux(rotate, data(31 downto 30) ## data(9 downto 0) ## data(29 downto 10), data(15 downto 0) ## word)
  }

  // Jobs not yet done: at most two, as many as there are banks.
  val jobs = RegInit(U(0, 2 bits))
  io.drawing := jobs =/= 0
  jobs := jobs + U(io.job.fire) - U(io.jobDone)

  // Texels beyond the memory have an address of their own, after its end.
  private val texelBits = log2Up(config.textureTexels)
  private val addressBits = log2Up(layout.triangles + 1).max(texelBits + 1)
  // Address of a vertex's word or a texel; counts up as words are written.
  val address = Reg(UInt(addressBits bits))
  val count = False
  val frameHeader = new FrameHeader(config, data(15 downto 0))
  val triangle =
    new TriangleAssembly(config, frameHeader.tag, data(9 downto 0).asUInt, io.store.rsp.payload, state === response)
  val vertexOffset = triangle.tagRead ## triangle.tagRead // 0, or 3: the word that holds the tag
  private val index = data(config.vertexBits - 1 downto 0)
  val vertexWord = ((index ## vertexOffset).asUInt +^ index.asUInt).resize(addressBits)
  when(count || state === loadVertex || state === load || state === loadTexel) {
    val texelBlock = (data(10 downto 0) << 4).asUInt.resize(addressBits)
    val blockBits = texelBits - 4
    if (blockBits < 11) when(data(10 downto blockBits).orR)(texelBlock(addressBits - 1 downto texelBits) := 1)
    address := Mux(count, address + 1, Mux(is_(Command.Texels), texelBlock, vertexWord))
  }

  val vertices = Reg(UInt(CommandDecoder.CountBits bits)) // arrived since begin
  val beyond = Reg(Bool()) // the vertex index is
  val pair = Reg(UInt(3 bits)) // of the vertex's words
  val check = VertexCheck(config.ranges)
  check.io.clear := False
  check.io.word.valid := io.words.valid && is_(Command.Vertices) && (state === fetchFirst || state === fetchSecond)
  check.io.word.payload := word
  check.io.pair := pair
  check.io.second := state === writeVertex

  val placeBits = layout.bankAddressBits
  val place = UInt(placeBits bits)
  val half = state === writeBox // of a triangle's two words
  place := address.resized
  when(state === writeIndices || half)(place := layout.triangles + (triangle.stored ## half).asUInt.resize(placeBits))
  when(state === writeState)(place := layout.states + triangle.renderState.asUInt.resize(placeBits))
  // The store is asked a clock after a state wants to, so that a register alone decides who has its port.
  val ask = False
  val asking = RegNext(ask && !io.store.cmd.fire) init False
  val served = io.store.cmd.fire
  io.store.cmd.valid := asking
  // What is not to be stored is read in place of written: nobody looks at the answer.
  val spare = state === writeVertex && (beyond || check.io.fault && pair =/= 3)
  io.store.cmd.write := state =/= read && !spare
  io.store.cmd.address := frameHeader.bank.asUInt @@ place
  io.store.cmd.data := data
  when(half)(io.store.cmd.data := triangle.renderState ## data(27 downto 20) ## triangle.boxBits)
  when(state === writeVertex && pair === 3) {
    io.store.cmd.data(31 downto 25) := frameHeader.tag ^ (check.io.fault ## B(0, 6 bits))
  }

  val texelFits = address < config.textureTexels
  io.texels.valid := state === texel && !none && io.words.valid && texelFits
  io.texels.address := address.resized
  io.texels.data := word

  // Of draw's counts, a clock after both words were taken.
  val mismatch = RegNext(
    data(31 downto 16).asUInt =/= vertices.resize(16) || data(15 downto 0).asUInt =/= triangle.arrived.resize(16)
  )
  io.job.valid := state === hand
  frameHeader.fill(io.job.payload, triangle.stored)

  io.events.accepted := state === finish && !refused
  io.events.refused := state === finish && refused
  io.events.vertexRefused := False
  io.events.triangleRefused := False
  io.events.incomplete := False

  /** Uses up the word in hand and goes on to `next`. */
  def after(next: SpinalEnumElement[DecoderState.type]): Unit = { take := True; when(io.words.valid)(state := next) }
  def nextGroup(): Unit = state := Mux(none, finish(), fetchFirst())

  switch(state) {
    is(header) {
      opcode := word(10 downto 8).asUInt
      left := word(6 downto 0).asUInt
      none := word(6 downto 0) === 0
      refused := False
      beyond := False
      pair := 0
      check.io.clear := True
      triangle.tagRead := False
      when(io.words.valid)(state := dispatch)
    }
    is(dispatch) {
      switch(opcode) {
        is(Command.Begin.opcode)(state := begin)
        is(Command.State.opcode)(state := renderState)
        is(Command.Vertices.opcode)(state := firstVertex)
        is(Command.Triangles.opcode)(state := renderState)
        is(Command.Texels.opcode)(state := texelAddress)
        is(Command.Draw.opcode)(state := drawVertices)
        default { refused := True; state := skip }
      }
      when(!frameHeader.open && !is_(Command.Begin) && !is_(Command.Texels)) { refused := True; state := skip }
    }
    is(skip) {
      take := !none
      when(none)(state := finish)
    }
    is(finish) {
      when(is_(Command.Begin))(frameHeader.open := !refused)
      state := header
    }

    is(begin) {
      frameHeader.open := False
      vertices := 0
      triangle.arrived := 0
      triangle.stored := 0
      frameHeader.vertical := False
      when(!jobs.msb)(state := frame)
    }
    is(frame) { frameHeader.tag := word(6 downto 0); after(color) }
    is(color) { frameHeader.takeColor(word); after(region) }
    is(region) {
      when(!frameHeader.vertical && frameHeader.badColor)(refused := True)
      after(range)
    }
    is(range) {
      when(judged) {
        frameHeader.takeRange()
        when(frameHeader.badRange)(refused := True)
        state := Mux(frameHeader.vertical, finish(), region())
      }
    }

    is(renderState)(after(loadState))
    is(loadState) {
      triangle.renderState := data(3 downto 0)
      when(judged) {
        state := Mux(high12, skip(), fetchFirst())
        when(high12)(refused := True)
      }
    }
    is(firstVertex)(after(loadVertex))
    is(loadVertex) {
      beyond := data(15 downto 0).asUInt >= config.maxVertices
      state := fetchFirst
    }

    is(fetchFirst)(after(fetchSecond))
    is(fetchSecond) {
      take := True
      triangle.start()
      when(io.words.valid) {
        state := load
        when(is_(Command.Vertices))(state := writeVertex)
        when(is_(Command.State))(state := writeState)
      }
    }
    is(writeState) {
      if (config.fixed.whole) state := finish // it is the one there is
      else {
        ask := True
        when(served)(state := finish)
      }
      if (config.fixed != FixedState.None) {
        def constant(v: Int) = B(BigInt(v & 0xffffffffL), 32 bits).rotateRight(16) // first word of the wire above
        when((data & constant(config.fixed.mask)) =/= constant(config.fixed.value)) {
          ask := False
          refused := True
          state := finish
        }
      }
    }
    is(writeVertex) {
      ask := !check.io.busy
      when(served) {
        count := True
        pair := pair + 1
        state := fetchFirst
        when(pair === PackedVertex.WireWords / 2 - 1) {
          pair := 0
          vertices := vertices + 1
          beyond setWhen (address === layout.triangles - 1)
          io.events.vertexRefused := check.io.fault || beyond
          check.io.clear := True
          nextGroup()
        }
      }
    }

    is(load)(state := read)
    is(read) {
      ask := True
      when(served)(state := response)
    }
    is(response) {
      triangle.answer()
      rotate := triangle.cornerDone
      state := Mux(triangle.cornerDone && triangle.lastCorner, settle(), load())
    }
    is(settle)(when(triangle.settle())(state := axisDone))
    is(axisDone) {
      when(!triangle.vertical) {
        triangle.turnVertical()
        state := load
      } otherwise {
        triangle.arrived := triangle.arrived + 1
        io.events.triangleRefused := triangle.refused
        when(triangle.refused || triangle.nothing)(nextGroup()) otherwise (state := writeIndices)
      }
    }
    is(writeIndices) {
      ask := True
      when(served)(state := writeBox)
    }
    is(writeBox) {
      ask := True
      when(served) { triangle.stored := triangle.stored + 1; nextGroup() }
    }

    is(texelAddress)(after(loadTexel))
    is(loadTexel) {
      when(judged) {
        when(high5) { // also keeps the address from wrapping
          refused := True
          state := skip
        } elsewhen (!io.drawing)(state := texel)
      }
    }
    is(texel) {
      when(none)(state := finish) otherwise {
        val goes = io.texels.ready || !texelFits
        take := goes
        count := goes && io.words.valid
        when(io.words.valid && !texelFits)(refused := True)
      }
    }

    is(drawVertices)(after(drawTriangles))
    is(drawTriangles)(after(compare))
    is(compare)(state := hand)
    is(hand) {
      when(io.job.ready) {
        io.events.incomplete := mismatch
        frameHeader.open := False
        frameHeader.bank := !frameHeader.bank
        state := finish
      }
    }
  }
}

object CommandDecoder {

  /** Vertices and triangles that arrive are counted modulo 4096, to be compared with what `draw` says was sent. */
  val CountBits = 12
}
