package frustum.raster.scan

import frustum.contract.raster.RasterConfig
import spinal.core._

/** Start, rows and end of a walk, and the handshake of its spans, whose pixels the walk itself offers. */
final class WalkControl(config: RasterConfig, io: EdgeWalkerPorts) extends Area {
  val asked, walking, ending = RegInit(False)
  val shown = RegInit(False) // a span is offered
  val lastColumn = RegNextWhen(io.lastColumn, io.start)
  val lastRow = RegNextWhen(io.lastRow, io.start)
  val y = Reg(UInt(config.tileLog2Height bits))

  /** Whether a span is in the way of the row that follows. */
  val blocked: Bool = shown && !io.up.ready

  when(io.up.ready) {
    shown := False
    when(!shown) { ending := False }
  }
  io.up.y := y
  io.up.end := !shown
  io.up.valid := shown || ending
  io.idle := !asked && !walking && !ending

  /** Walks once `start` has come and the edges are ready. */
  def begin(ready: Bool): Unit = {
    when(io.start) { y := io.firstRow - 1 }
    asked := (asked || io.start) && !ready
    when((asked || io.start) && ready) { walking := True }
  }

  /** Goes on to the next row, the first one as well. */
  def nextRow(): Unit = y := y + 1

  /** Ends a row, which has pixels if it is `filled`, and with the last row the walk. */
  def row(ends: Bool, filled: Bool, isLast: Bool): Unit = when(ends) {
    shown := filled
    when(isLast) { end() }
  }

  /** Ends the walk; no more than a span that is offered comes before the end marker. */
  def end(): Unit = {
    walking := False
    ending := True
  }
}
