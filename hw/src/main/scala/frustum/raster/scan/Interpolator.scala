package frustum.raster.scan

import frustum.contract.raster.{RasterConfig, SetupWords}
import spinal.core._
import spinal.lib._

/** One 32-bit coefficient of a plane (16 bits for the colours). */
case class CoefficientWrite(slots: Int) extends Bundle {
  val plane = UInt(3 bits)
  val slot = UInt(log2Up(slots) bits)
  val entry = UInt(3 bits)
  val value = SInt(32 bits)
}

object Coefficient {
  // entries of a slot
  val Initial = 0 // entries 0 and 1: one is read while the other is written
  // the step to the left is a complement: its negative, less one
  val Right = 2; val Left = 3; val Down = 4
}

/** Moves the attribute planes from pixel to pixel: one move per cycle, a fragment wherever a span is.
  *
  * Rows are walked in alternating directions. From the end of one row the move goes down and then sideways to the near
  * end of the next, so its cost is the edge's lateral move, which the edge walker takes longer for. Coefficients are in
  * memory, one entry per kind of move, so that an attribute costs an adder and its register.
  */
case class Interpolator(config: RasterConfig) extends Component {
  val io = new Bundle {
    val token = slave(Stream(DrawToken(config)))
    val spans = slave(Stream(Span(config)))
    val write = slave(Flow(CoefficientWrite(config.slots)))
    val busy = out Bool () // a token or its fragments are in flight
    val down = master(Stream(InterpolatedFragment(config)))
  }

  // The row to be drawn, from `near` to `far`.
  case class Row() extends Bundle {
    val y = UInt(config.tileLog2Height bits)
    val near, far = UInt(config.tileLog2Width bits)
    val end = Bool()
    val leftwards = Bool() // the row's direction
    val seekLeft = Bool() // the direction from the row before to `near`
  }
  val rows = Stream(Row())
  val row = rows.s2mPipe().m2sPipe() // ready has no combinational path through
  val leftwards = RegInit(False)
  when(rows.fire) { leftwards := !leftwards && !rows.end }
  rows.arbitrationFrom(io.spans)
  rows.y := io.spans.y
  rows.near := Mux(leftwards, io.spans.last, io.spans.first)
  rows.far := Mux(leftwards, io.spans.first, io.spans.last)
  rows.end := io.spans.end
  rows.leftwards := leftwards
  rows.seekLeft := rows.near < RegNextWhen(rows.far, rows.fire)

  // Cycle 1 of a move: the coefficient is requested.
  val x = Reg(UInt(config.tileLog2Width bits))
  val y = Reg(UInt(config.tileLog2Height bits))
  val moving = RegInit(False) // a triangle is being drawn: cycle 2 of its last move, to (x, y)
  val drawing = Reg(Bool()) // the move before was a fragment of the same row
  val ending = RegInit(False) // cycle 2 of a tile's end
  val free = Bool() // the register of `down` is free
  val advance = free && row.valid // a move goes from cycle 2 to the register of `down`
  val atY = y === row.y
  val reached = drawing || x === row.near
  val atFar = x === row.far
  val covered = atY && reached
  val rowDone = covered && atFar
  val inRow = atY && !(reached && atFar) // the move stays in the row
  val finish = moving && row.end
  val toLeft = Mux(reached, row.leftwards, row.seekLeft)
  // Coefficient.Left or Right, Down, or an Initial one
  val entry = (moving && !inRow) ## (moving && inRow) ## Mux(moving, inRow && toLeft, io.token.parity)
  val starts = !moving && !ending && io.token.valid && !io.token.tileEnd && row.valid
  val ends = !moving && !ending && io.token.valid && io.token.tileEnd
  val moves = (moving || starts) && advance
  io.token.ready := finish && advance || ends
  row.ready := moving && free && (row.end || rowDone)
  when(ends) { ending := True }
  when(ending && free) { ending := False }
  when(moves) {
    moving := !finish
    drawing := moving && covered && !rowDone
    when(!moving) {
      x := io.token.x
      y := row.y
    } elsewhen (inRow) {
      x := Mux(toLeft, x - 1, x + 1)
    } otherwise {
      y := y + 1
    }
  }

  // Cycle 2: it is added. In place of the move before the end marker, the planes become zero: the next move brings
  // another triangle's first value.
  val complement = RegNextWhen(moving && inRow && toLeft, moves) // adds the one that the step to the left lacks
  private def fullWidth(plane: Int) =
    if (plane < SetupWords.PlaneQ) config.ranges.coordinateBits else if (plane <= SetupWords.PlaneZ) 32 else 16
  val planes = for (plane <- config.fixed.planes) yield new Area {
    val full = fullWidth(plane)
    val dropped = config.formats.dropped(plane)
    val width = full - dropped
    val memory = Mem(SInt(width bits), config.slots * 8)
    memory.write(
      io.write.slot @@ io.write.entry,
      (io.write.value >> dropped).resize(width),
      io.write.valid && io.write.plane === plane
    )
    val coefficient = memory.readSync(io.token.slot @@ entry.asUInt, enable = moves, readUnderWrite = dontCare)
    val value = RegInit(S(0, width bits))
    when(moving && advance) {
      value := value + coefficient + complement.asUInt.resize(width).asSInt
      when(row.end) { value := 0 }
    }
  }

  val valid = RegInit(False)
  val tileEnd = Reg(Bool())
  when(free) {
    valid := moving && row.valid && !row.end && covered || ending
    tileEnd := ending
  }
  free := !valid || io.down.ready
  io.busy := io.token.valid || moving || ending || valid
  io.down.valid := valid
  io.down.x := RegNextWhen(x, advance)
  io.down.y := RegNextWhen(y, advance)
  io.down.tileEnd := tileEnd
  import SetupWords._
  Seq(
    PlaneS -> io.down.s,
    PlaneT -> io.down.t,
    PlaneQ -> io.down.q,
    PlaneZ -> io.down.z,
    PlaneR -> io.down.r,
    PlaneG -> io.down.g,
    PlaneB -> io.down.b,
    PlaneA -> io.down.a
  )
    .foreach { case (plane, to) =>
      val made = config.fixed.planes.indexOf(plane)
      if (made < 0) to := 0 else to := (planes(made).value << planes(made).dropped).resize(to.getWidth)
    }
}
