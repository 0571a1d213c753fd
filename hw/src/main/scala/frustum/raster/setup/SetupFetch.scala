package frustum.raster.setup

import frustum.contract.Field
import frustum.contract.raster.{
  FetchProgram,
  RasterConfig,
  SetupMemory,
  SetupWords,
  StoreLayout,
  StoredTriangle,
  StoredVertex
}
import frustum.contract.raster.FetchProgram.Source
import frustum.raster.link.StoreAddress
import frustum.raster.scan.SpareRows
import frustum.raster.store.FieldBits._
import frustum.raster.store.StoreBus
import spinal.core._
import spinal.lib._

/** A word for the set-up engine's scratch memory. */
case class ScratchWrite() extends Bundle {
  val word = UInt(SetupMemory.CodeBits bits)
  val data = SInt(32 bits)
}

/** A row of the table, as [[frustum.contract.raster.FetchProgram]] encodes it. */
case class FetchRow() extends Bundle {
  val target, origin = UInt(SetupMemory.CodeBits bits)
  val sources = Bits(Source.Skip.id bits)
  val word = UInt(3 bits)
  val upper, take = Bool()
  val lastOfWord, last = Bool()
}

/** Writes words into the set-up engine's scratch memory: with `start`, a triangle's three vertices from the store, or,
  * with `program` at 48 or more, that program of [[frustum.contract.raster.FetchProgram]]. A row a cycle, and a store
  * read for each store word. The last word is written three cycles after `idle` is back, before the engine can read it.
  *
  * @param planes that are needed
  */
case class SetupFetch(config: RasterConfig, spareRows: Int, planes: Seq[Int] = SetupWords.AllPlanes) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val start = in Bool ()
    val program = in UInt (6 bits) // first row of the program; 0 for a triangle's vertices
    val idle = out Bool ()
    val triangle = in UInt (config.triangleBits bits)
    val bank = in UInt (1 bits)
    val values = in(FetchValues(config))
    val store = master(StoreBus(layout))
    val read = out UInt (SetupMemory.CodeBits bits)
    val readData = in SInt (32 bits)
    val write = master(Flow(ScratchWrite()))
    val spare = slave(SpareRows(spareRows, config.triangleBits))
  }

  object State extends SpinalEnum { val Idle, Vertices, Exponents, Read, Wait, Write = newElement() }
  val state = RegInit(State.Idle)
  val row = Reg(UInt(6 bits))
  val nextRow = UInt(6 bits)
  val vertex = row(5 downto 4)
  val lastVertex = vertex.msb
  nextRow := row
  row := nextRow
  val start = RegNext(io.start, False)
  val program = RegNext(io.program)
  val resting = state === State.Idle && !start
  io.idle := resting

  // The table: the programs, then the spare rows.
  val firstSpare = FetchProgram.Rows
  val rows = firstSpare + (1 << log2Up(spareRows))
  val table = Mem(Bits(FetchProgram.RowBits bits), rows)
  table.init(FetchProgram.image(planes).padTo(rows, 0).map(B(_, FetchProgram.RowBits bits)))
  table.addAttribute("ram_style", "block")
  def spare(address: UInt) = U(firstSpare, log2Up(rows) bits) | address.resize(log2Up(rows))
  table.write(
    spare(io.spare.write.address),
    io.spare.write.data.asBits.resize(FetchProgram.RowBits),
    io.spare.write.valid
  )
  val read = table.readSync(
    Mux(resting, spare(io.spare.address), nextRow.resize(log2Up(rows))),
    readUnderWrite = dontCare
  )
  io.spare.free := resting
  io.spare.data := read(config.triangleBits - 1 downto 0).asUInt
  val action = FetchRow()
  action.assignFromBits(read)
  def isFrom(kind: Source.Value) = action.sources(kind.id)

  // Store reads: the vertices' indices, the three exponents, then word after word of each vertex. Indices and exponents
  // rotate, the current vertex first.
  val indices = Vec.fill(3)(Reg(UInt(config.vertexBits bits)))
  val exponents = Vec.fill(3)(Reg(UInt(5 bits)))
  def turn[T <: Data](ring: Vec[T]): Unit = { ring(0) := ring(1); ring(1) := ring(2); ring(2) := ring(0) }
  val ask = False // a read of the store, whose address follows a cycle later
  val asking = RegInit(False) clearWhen io.store.cmd.fire setWhen RegNext(ask, False)
  val wanted = Mux(state === State.Exponents, U(StoredVertex.QExponent.slice.word, 3 bits), action.word)
  val response = io.store.rsp
  io.store.cmd.valid := asking
  io.store.cmd.write := False
  io.store.cmd.data := 0
  val ofVertex = StoreAddress.vertex(layout, indices(0), wanted)
  val ofTriangle = StoreAddress.triangle(layout, io.triangle, U(StoredTriangle.V0.slice.word, 1 bits))
  io.store.cmd.address := io.bank @@ RegNext(Mux(state === State.Vertices, ofTriangle, ofVertex))
  val largest = Reg(UInt(5 bits))
  val arriving = StoredVertex.QExponent.in(response.payload).asUInt

  val data = Reg(Bits(32 bits)) // a store word; the next field is always at its top

  // Cycle 1 of a row: the word to subtract is requested from the scratch memory; cycle 2: the difference; cycle 3: its
  // place; cycle 4: the write.
  val working = state === State.Write
  val values = io.values
  io.read := action.origin
  // A centre: of the tile's first column or line, or the last one, or the covered one.
  def centre(tile: UInt, last: UInt, covered: UInt): UInt = {
    val of = action.word.asBits
    val pixel = last.asBits & of(1) #* widthOf(last) | covered.asBits & of(2) #* widthOf(covered)
    (tile @@ pixel.asUInt @@ U(8, 4 bits)).resize(14)
  }
  val column = centre(values.tileX, values.lastColumn, values.coveredX)
  val line = centre(values.tileY, values.lastRow, values.coveredY)
  // A field of a width, at the word's top; a texture coordinate never moves.
  def top(field: Field) = data(31 downto 32 - field.width)
  val top16 = top(StoredVertex.X)
  val alike = RegNext(exponents(0) === exponents(1) && exponents(1) === exponents(2))
  val flat = RegNextWhen(alike && top16(14 downto 0) === 0, isFrom(Source.Q)) // the mantissa of 1/w is a power of two
  val texelBias = B(SetupWords.TexelBias, SetupWords.TexelBiasBits bits) & flat #* SetupWords.TexelBiasBits
  val minuend = RegNext(
    Seq[(Source.Value, BitVector)](
      Source.Position -> top16.asSInt.resize(32),
      Source.Z -> (top16 << 15),
      Source.Q -> (top16 << 1),
      Source.Color -> (top(StoredVertex.R) << 7),
      Source.Texture -> (StoredVertex.S.in(data) ## texelBias).asSInt.resize(32),
      Source.Area -> (values.area | (1 << 29) | 1),
      Source.Pixel -> Mux(action.word.lsb, line, column)
    ).map { case (f, v) => v.asBits.resize(32) & isFrom(f) #* 32 }.reduceBalancedTree(_ | _).asSInt
  )
  val difference = RegNext(minuend - io.readData)
  val raise = Delay(action.upper, 2)
  val behind = RegNext(largest - exponents(0))
  val place = RegNext(Mux(RegNext(isFrom(Source.Scale)), behind, values.place))
  val isPower = Delay(working && (isFrom(Source.Scale) || isFrom(Source.Power)), 2, init = False)
  // Bit 30 - n for place n, and bit 0 for place 31 too, from lines for the upper and the lower bits of ~n.
  val group = (~place)(4 downto 2)
  val lines = B((0 to 7).map(isPower && group === _))
  val four = B((0 to 3).map((~place)(1 downto 0) === _))
  val bits = (0 to 31).map(n => lines(n / 4) && four(n % 4))
  val power = B((bits(0) || bits(1)) +: bits.drop(2) :+ False)
  io.write.valid := Delay(working && action.sources.orR, 3, init = False)
  io.write.word := Delay(action.target, 3)
  io.write.data := RegNext(Mux(raise, difference |<< 16, difference) | power.asSInt)

  switch(state) {
    is(State.Idle) {
      nextRow := program
      largest := 0
      when(start) {
        ask := !program.msb
        state := Mux(program.msb, State.Write, State.Vertices)
      }
    }
    is(State.Vertices) {
      when(response.valid) {
        for ((index, corner) <- indices.zip(StoredTriangle.corners))
          index := corner.in(response.payload).asUInt.resize(config.vertexBits)
        state := State.Exponents
        ask := True
      }
    }
    is(State.Exponents) {
      when(response.valid) {
        turn(indices)
        exponents(0) := exponents(1)
        exponents(1) := exponents(2)
        exponents(2) := arriving
        when(arriving > largest) { largest := arriving }
        nextRow(5 downto 4) := Mux(lastVertex, U(0), vertex + 1)
        ask := True
        when(lastVertex) { state := State.Read }
      }
    }
    is(State.Read) { when(io.store.cmd.fire) { state := State.Wait } }
    is(State.Wait) {
      data := response.payload
      when(response.valid) { state := State.Write }
    }
    is(State.Write) {
      nextRow := row + 1
      when(action.take) { data := data |<< 8 }
      when(action.lastOfWord) {
        state := State.Read
        ask := True
      }
      when(action.last) {
        nextRow := (vertex + 1) @@ U(0, 4 bits)
        turn(indices)
        turn(exponents)
        when(row.msb) { // vertex 2, or another program
          state := State.Idle
          ask := False
        }
      }
    }
  }
}
