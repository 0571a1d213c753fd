package frustum.raster

import frustum.spec.{RasterConfig, SetupWords}
import spinal.core._
import spinal.lib._

/** What starts the drawing of a triangle's part in a tile, or ends the tile.
  *
  * The planes' values at the first pixel of the first span, whose column is `x`, lie in the slot's entry `parity`.
  */
case class DrawToken(config: RasterConfig, slots: Int) extends Bundle {
  val tileEnd = Bool()
  val state   = UInt(4 bits) // render state index
  val slot    = UInt(log2Up(slots) bits)
  val parity  = Bool()
  val x       = UInt(config.tileLog2Width bits)
}

/** One 32-bit coefficient of a plane (16 bits for the colours). */
case class CoefficientWrite(slots: Int) extends Bundle {
  val plane = UInt(3 bits)
  val slot  = UInt(log2Up(slots) bits)
  val entry = UInt(3 bits)
  val value = SInt(32 bits)
}

object Coefficient {
  // entries of a slot
  val Initial = 0 // and 1: one is read while the other is written
  // the step to the left is a complement: its negative, less one
  val Right = 2; val Left = 3; val Down = 4
}

/** Moves the attribute planes from pixel to pixel: one move a clock, a fragment wherever a span is.
  *
  * Rows are walked to and fro. From the end of one row the move goes down and then sideways to the near end of the next,
  * so its cost is the edge's lateral move, which the edge walker takes longer for. Coefficients lie in memory, one entry per kind of move, so
  * that an attribute costs an adder and its register.
  */
case class Interpolator(config: RasterConfig, slots: Int) extends Component {
  val io = new Bundle {
    val token = slave Stream (DrawToken(config, slots))
    val spans = slave Stream (Span(config))
    val write = slave Flow (CoefficientWrite(slots))
    val busy  = out Bool () // a token or its fragments are under way
    val down  = master Stream (InterpolatedFragment(config))
  }

  case class Move() extends Bundle {
    val entry   = UInt(3 bits)
    val slot    = UInt(log2Up(slots) bits)
    val clear   = Bool() // the planes become zero: the next move brings another triangle's first value
    val emit    = Bool()
    val tileEnd = Bool()
    val x       = UInt(config.tileLog2Width bits)
    val y       = UInt(config.tileLog2Height bits)
  }

  object State extends SpinalEnum { val Start, Row, Seek, Draw = newElement() }
  val state     = RegInit(State.Start)
  val x         = Reg(UInt(config.tileLog2Width bits))
  val y         = Reg(UInt(config.tileLog2Height bits))
  val leftwards = Reg(Bool())
  val span      = io.spans.payload

  // One move a clock. A row is drawn from `target` to `goal`.
  val starting = state === State.Start
  val drawing  = state === State.Draw
  val target   = leftwards ? span.last | span.first
  val goal     = (leftwards && !starting) ? span.first | span.last
  val back     = (drawing ? goal | target) < x
  val nextX = UInt(config.tileLog2Width bits)
  val nextY = UInt(config.tileLog2Height bits)
  val moves = Stream(Move())
  nextX := back ? (x - 1) | (x + 1)
  nextY := y
  moves.valid := io.spans.valid
  moves.entry := back ? U(Coefficient.Left, 3 bits) | U(Coefficient.Right, 3 bits)
  moves.slot := io.token.slot
  moves.clear := False
  moves.emit := drawing || nextX === target
  moves.tileEnd := False
  switch(state) {
    is(State.Start) {
      moves.valid := io.token.valid && (io.token.tileEnd || io.spans.valid)
      moves.entry := io.token.parity.asUInt.resized
      moves.tileEnd := io.token.tileEnd
      moves.clear := io.token.tileEnd
      moves.emit := !io.token.tileEnd
      nextX := io.token.x
      nextY := span.y
    }
    is(State.Row) {
      moves.entry := Coefficient.Down
      moves.clear := span.end
      nextX := x
      nextY := y + 1
      moves.emit := !span.end && nextY === span.y && x === target
    }
  }
  moves.x := nextX
  moves.y := nextY

  val rowDone = moves.emit && nextX === goal
  io.spans.ready := moves.fire && (rowDone || state === State.Row && span.end)
  io.token.ready := moves.fire && moves.clear
  when(moves.fire) {
    x := nextX
    y := nextY
    when(moves.clear) {
      state := State.Start
    } elsewhen (rowDone) {
      leftwards := starting || !leftwards
      state := State.Row
    } elsewhen (moves.emit) {
      when(starting) { leftwards := False }
      state := State.Draw
    } elsewhen (state === State.Row && nextY === span.y) {
      state := State.Seek
    }
  }

  // The coefficients of the move are read, then added.
  val read       = moves.m2sPipe()
  val complement = read.entry === Coefficient.Left
  val widths = Seq.fill(4)(32) ++ Seq.fill(4)(16)
  val planes = for ((width, plane) <- widths.zipWithIndex) yield new Area {
    val memory = Mem(SInt(width bits), slots * 8)
    memory.write(io.write.slot @@ io.write.entry, io.write.value.resize(width), io.write.valid && io.write.plane === plane)
    val coefficient =
      memory.readSync(moves.slot @@ moves.entry, enable = moves.ready, readUnderWrite = dontCare)
    val value = RegInit(S(0, width bits))
    when(read.fire) {
      when(read.clear) { value := 0 } otherwise {
        value := value + coefficient + complement.asUInt.resize(width).asSInt
      }
    }
  }

  val added = read.m2sPipe()
  val fragments = added.throwWhen(!added.emit && !added.tileEnd)
  io.busy := io.token.valid || read.valid || added.valid
  io.down.arbitrationFrom(fragments)
  io.down.x := fragments.x
  io.down.y := fragments.y
  io.down.tileEnd := fragments.tileEnd
  import SetupWords._
  Seq(PlaneS -> io.down.s, PlaneT -> io.down.t, PlaneQ -> io.down.q, PlaneZ -> io.down.z,
    PlaneR -> io.down.r, PlaneG -> io.down.g, PlaneB -> io.down.b, PlaneA -> io.down.a)
    .foreach { case (plane, to) => to := planes(plane).value }
}
