package frustum.raster.link

import frustum.contract.raster.{BeginLayout, RasterConfig, StoredVertex}
import frustum.raster.store.FieldBits._
import spinal.core._
import spinal.lib._

/** Executes `begin`: waits for a free bank and keeps what the frame is to be. A frame is `open` from a good `begin`
  * until it is drawn or another `begin` comes.
  */
case class BeginCommand(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(GroupPort())
    val free = in Bool () // a bank is free
    val drawn = in Bool () // the frame goes to the rasterizer
    val open = out(RegInit(False))
    val fresh = out Bool () // nothing of the frame has arrived yet
    val tag = out(Reg(Bits(StoredVertex.Tag.width bits)))
    val clearColor = out Bits (16 bits)
    val region = out(Vec.fill(4)(Reg(UInt(5 bits)))) // x0, x1, y0, y1, inclusive
  }
  val group = io.up.group
  val step = Reg(UInt(2 bits)) // of the group after the first: colour 1, columns 2, rows 3
  when(group.fire)(step := Mux(group.first, U(1), step + 1))
  val ofColor = !group.first && step === 1
  val ofRange = !group.first && step =/= 1
  val ofRows = step.lsb

  val clearColor = config.clearColor.fold(Reg(Bits(16 bits)))(B(_, 16 bits))
  val badColor = Bool(config.clearColor.isDefined) && group.single =/= clearColor
  io.clearColor := clearColor

  // Columns and rows have the same bits.
  val ends = Seq(BeginLayout.X0, BeginLayout.X1).map(_.in(group.single).asUInt)
  val beyond = ends.map(_(7 downto 5).orR).orR // outside the largest screen
  val firstTile = ends(0).resize(5)
  val lastTile = ends(1).resize(5)
  val limit = Mux(ofRows, U(config.tilesY - 1, 5 bits), U(config.tilesX - 1, 5 bits))
  val badRange = RegNext(beyond || firstTile > lastTile || lastTile > limit)

  group.ready := !group.first || io.free
  io.up.refuse := ofColor && badColor || ofRange && badRange
  io.fresh := group.valid && group.first
  when(io.fresh) {
    io.open := False
    io.tag := BeginLayout.Frame.in(group.single).resize(StoredVertex.Tag.width)
  }
  if (config.clearColor.isEmpty) when(group.valid && ofColor)(clearColor := group.single)
  when(group.fire && ofRange) {
    io.region(0) := io.region(2).resize(config.tileXBits).resized
    io.region(1) := io.region(3).resize(config.tileXBits).resized
    io.region(2) := firstTile
    io.region(3) := lastTile
    io.open := group.last && !badRange
  }
  when(io.drawn)(io.open := False)
}
