package frustum.video

import frustum.contract.video.VideoMode
import spinal.core._
import spinal.lib._

/** Position in a picture: counters that begin with the visible part, and pulses that follow from them.
  *
  *   - `x`, `y`: position, also beyond the visible part
  *   - `active`: the pixel of this cycle is visible; `hSync`, `vSync` in the mode's polarity
  *   - `line`: one cycle at the start of the horizontal blank before each visible row
  *   - `frameEnd`: one cycle in the first blank row, `PixelScanner.Tail` cycles into it
  */
case class PixelScanner(mode: VideoMode) extends Component {
  import mode._
  val io = new Bundle {
    val x = out UInt (log2Up(hTotal) bits)
    val y = out UInt (log2Up(vTotal) bits)
    val active = out Bool ()
    val hSync, vSync = out Bool ()
    val line, frameEnd = out Bool ()
  }
  require(width > PixelScanner.Tail, s"rows of $width pixels, more than ${PixelScanner.Tail} are needed")

  // Starts in the blank, so that the first frame is complete.
  val x = Reg(UInt(log2Up(hTotal) bits)) init 0
  val y = Reg(UInt(log2Up(vTotal) bits)) init height
  val last = RegNext(x === hTotal - 2) init False // x is at its end: known when the cycle begins
  x := x + 1
  when(last) {
    x := 0
    y := y + 1
    when(y === vTotal - 1)(y := 0)
  }
  io.x := x
  io.y := y

  val columns = RegInit(True) setWhen last clearWhen (x === width - 1)
  val rows = RegInit(False)
  when(last) {
    when(y === height - 1)(rows := False)
    when(y === vTotal - 1)(rows := True)
  }
  io.active := columns && rows

  val h = x >= width + hFront && x < width + hFront + hSync
  val v = y >= height + vFront && y < height + vFront + vSync
  io.hSync := (if (hPositive) h else !h)
  io.vSync := (if (vPositive) v else !v)

  val beforeVisible = y === vTotal - 1 || (rows && y =/= height - 1)
  io.line := x === width && beforeVisible
  io.frameEnd := x === PixelScanner.Tail && y === height
}

object PixelScanner {

  /** Clocks from a frame's last row to `frameEnd`: longer than any pipeline behind the scanner. */
  val Tail = 64
}
