package frustum.raster.scan

import frustum.contract.Field
import frustum.contract.raster.{RasterConfig, StoreLayout, StoredTriangle}
import frustum.raster.link.StoreAddress
import frustum.raster.store.FieldBits._
import frustum.raster.store.{FrameJob, StoreBus}
import frustum.raster.tile.TilePosition
import spinal.core._
import spinal.lib._

/** Walks a frame's tiles row by row and, for each, all triangles in order: a triangle whose box misses the tile costs
  * one cycle. Runs ahead of the set-up by one triangle.
  *
  * `frame` is taken when the units after this one have finished its last job (`drained`); `tile` announces each tile
  * before its jobs.
  */
case class TileSequencer(config: RasterConfig) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val frame = slave(Stream(FrameJob(config)))
    val store = master(StoreBus(layout))
    val tile = master(Stream(TilePosition()))
    val job = master(Stream(TileJob(config)))
    val drained = in Bool () // no job is in flight
  }

  object State extends SpinalEnum { val Idle, Tile, Settle, Scan, Hand, End, Drain = newElement() }
  val state = RegInit(State.Idle)
  val tile = Reg(TilePosition())
  val next = Reg(UInt(config.countBits bits)) // the next triangle to be compared
  val following = next + 1
  val atLeft, atTop = Reg(Bool()) // the tile is in the frame's first column, row
  val frame = io.frame.payload

  // A box is requested every cycle. It is compared with the tile when it arrives, and the result is used a cycle later;
  // after a hit the boxes still in flight are ignored.
  val asked = Reg(UInt(config.triangleBits bits)) // the next box to be requested
  val pending = Reg(UInt(2 bits)) init 0 // boxes in flight
  val response = io.store.rsp
  def box(of: Field) = of.in(response.payload).asUInt
  val looking = RegNext(response.valid, False)
  val inside = RegNext(box(StoredTriangle.X0) <= tile.tileX) && RegNext(box(StoredTriangle.X1) >= tile.tileX) &&
    RegNext(box(StoredTriangle.Y0) <= tile.tileY) && RegNext(box(StoredTriangle.Y1) >= tile.tileY)
  val starts = (RegNext(box(StoredTriangle.X0) === tile.tileX) || atLeft) &&
    (RegNext(box(StoredTriangle.Y0) === tile.tileY) || atTop) // the box, here
  val boxState = RegNext(StoredTriangle.State.in(response.payload).asUInt)
  val ended = Reg(Bool()) // none is left to be compared
  val hitTriangle = Reg(UInt(config.triangleBits bits))
  val hitState = Reg(UInt(4 bits))
  val hitFirst = Reg(Bool())

  io.store.cmd.valid := state === State.Scan && pending =/= 3
  io.store.cmd.write := False
  io.store.cmd.data := 0
  io.store.cmd.address := frame.bank @@
    StoreAddress.triangle(layout, asked, U(StoredTriangle.X0.slice.word, log2Up(layout.triangleWords) bits))
  when(io.store.cmd.fire) { asked := asked + 1 }
  pending := pending + io.store.cmd.fire.asUInt - response.valid.asUInt
  io.tile.valid := state === State.Tile
  io.tile.payload := tile
  io.job.valid := state === State.Hand || state === State.End
  io.job.tileEnd := state === State.End
  io.job.tileX := tile.tileX
  io.job.tileY := tile.tileY
  io.job.triangle := hitTriangle
  io.job.state := hitState
  io.job.first := hitFirst
  io.frame.ready := False

  switch(state) {
    is(State.Idle) {
      tile.tileX := frame.x0
      tile.tileY := frame.y0
      atLeft := True
      atTop := True
      when(io.frame.valid) { state := State.Tile }
    }
    is(State.Tile) {
      next := 0
      asked := 0
      ended := frame.triangleCount === 0
      when(io.tile.ready) { state := State.Settle }
    }
    is(State.Settle) { when(pending === 0 && !looking) { state := State.Scan } }
    is(State.Scan) {
      when(ended) {
        state := State.End
      } elsewhen (looking) {
        next := following
        ended := following === frame.triangleCount
        hitTriangle := next.resized
        hitFirst := starts
        hitState := (if (config.fixed.whole) U(0) else boxState) // any will do
        when(inside) { state := State.Hand }
      }
    }
    is(State.Hand) {
      asked := next.resized
      when(io.job.ready) { state := State.Settle }
    }
    is(State.End) {
      when(io.job.ready) {
        tile.tileX := (tile.tileX + 1).resize(config.tileXBits).resized
        atLeft := False
        state := State.Tile
        when(tile.tileX === frame.x1) {
          tile.tileX := frame.x0
          tile.tileY := tile.tileY + 1
          atLeft := True
          atTop := False
          when(tile.tileY === frame.y1) {
            state := State.Drain
          }
        }
      }
    }
    is(State.Drain) {
      when(io.drained) {
        io.frame.ready := True
        state := State.Idle
      }
    }
  }
}
