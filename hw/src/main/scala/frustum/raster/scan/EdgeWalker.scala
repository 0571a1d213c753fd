package frustum.raster.scan

import frustum.contract.raster.{RasterConfig, WalkerKind}
import spinal.core._
import spinal.lib._

/** Pixels `first` to `last` of row `y` of the tile, inclusive; or, with `end`, no pixels and no more of the triangle.
  */
case class Span(config: RasterConfig) extends Bundle {
  val y = UInt(config.tileLog2Height bits)
  val first, last = UInt(config.tileLog2Width bits)
  val end = Bool()
}

/** What an edge walker is connected by; see [[EdgeWalker]]. */
case class EdgeWalkerPorts(config: RasterConfig) extends Bundle {
  val lastColumn = in UInt (config.tileLog2Width bits) // of the pixels of the tile that are on the screen
  val firstRow, lastRow = in UInt (config.tileLog2Height bits) // that the triangle may touch
  val step = slave(Flow(SInt(17 bits)))
  val edge = slave(Flow(new Bundle { val index = UInt(2 bits); val value = SInt(32 bits) }))
  val start = in Bool ()
  val idle = out Bool ()
  val up = master(Stream(Span(config)))
}

/** Finds the pixels of a triangle in a tile: from `firstRow` down to `lastRow`, each row's span, then the end marker.
  *
  * Each of the three edge functions keeps the outermost pixel of the row that it lets through (the leftmost where the
  * function grows to the right), stepping inwards or outwards from the row above: integer edge functions at pixel
  * centres, Pineda 1988; see [[EdgeMove]]. The walk ends early where the edges that never move outwards again leave
  * nothing.
  *
  * Cycles: by `config.walker`, see [[SerialWalk]] and [[ParallelWalk]]. While `up` is not ready the span is held.
  *
  * To load, while `idle`: per edge its steps per 1/16 pixel (x then y, edge after edge, never both 0) and, edge after
  * edge too, each after its steps, the last after all, its function in row `firstRow`, at the left column or, where the
  * x step is negative, at `lastColumn`, in 1/256 pixel^2; then `start`, with which `lastColumn` and the rows are taken.
  */
case class EdgeWalker(config: RasterConfig) extends Component {
  val io = EdgeWalkerPorts(config)
  val walk = config.walker match {
    case WalkerKind.Serial   => new SerialWalk(config, io)
    case WalkerKind.Parallel => new ParallelWalk(config, io)
  }
}
