package frustum.video

import frustum.contract.video.{Font, TextField}
import spinal.core._
import spinal.lib._

/** Letters over a picture, in fields at fixed places; earlier fields cover later ones.
  *
  * `io.cell` and `io.dot` belong to the position of `TextOverlay.Latency` cycles before: inside a field that is shown,
  * and on a dot of its letter.
  *
  * @param bits
  *   of the position's coordinates
  */
case class TextOverlay(fields: Seq[TextField], bits: Int) extends Component {
  require(fields.nonEmpty, "text overlay without fields")
  val io = new Bundle {
    val x, y = in UInt (bits bits)
    val text = in(TextOverlay.text(fields))
    val shown = in Bits (fields.size bits)
    val cell, dot = out Bool ()
  }
  private val codes = Mem(Bits(Font.Cell bits), Font.table.map(B(_, Font.Cell bits)))

  private case class Spot() extends Bundle {
    val inside = Bool()
    val code = UInt(Font.CodeBits bits)
    val row, column = UInt(log2Up(Font.Cell) bits)
  }
  private def spot(f: TextField, index: Int) = {
    val s = Spot()
    val shift = log2Up(f.cell)
    val letter = io.x >> shift
    s.inside := io.shown(index) && (io.y >> shift) === f.row &&
      letter >= f.column && letter < f.column + f.length
    s.code := io.text(index)((letter - f.column).resize(log2Up(f.length)))
    s.row := (io.y >> f.scale).resized
    s.column := (io.x >> f.scale).resized
    s
  }
  private val spots = fields.zipWithIndex.map { case (f, i) => RegNext(spot(f, i)) }
  private val first = spots.reduceRight((above, below) => Mux(above.inside, above, below))
  private val row = codes.readSync(first.code @@ first.row)
  private val seen = RegNext(first)
  io.cell := RegNext(seen.inside) init False
  io.dot := RegNext(seen.inside && row.reversed(seen.column)) init False
}

object TextOverlay {

  /** Codes of letters, field by field. */
  def text(fields: Seq[TextField]): Vec[Vec[UInt]] =
    Vec(fields.map(f => Vec.fill(f.length)(UInt(Font.CodeBits bits))))

  /** Field, letter's row, dot. */
  val Latency = 3
}
