package frustum.raster

import frustum.frame.TilePosition
import frustum.link.{FrameJob, StoreBus}
import frustum.spec.{RasterConfig, StoreLayout}
import spinal.core._
import spinal.lib._

/** Walks a frame's tiles row by row and, for each, all triangles in order: a triangle whose box misses the tile costs one
  * clock. Runs ahead of the set-up by one triangle.
  *
  * `frame` is taken when its last job has left the units behind (`drained`); `tile` announces each tile before its jobs.
  */
case class TileSequencer(config: RasterConfig) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val frame = slave Stream (FrameJob())
    val store = master(StoreBus(layout))
    val tile  = master Stream (TilePosition())
    val job   = master Stream (TileJob(config))
    val drained = in Bool () // no job is under way
  }

  object State extends SpinalEnum { val Idle, Tile, Scan, Hand, End, Drain = newElement() }
  val state    = RegInit(State.Idle)
  val tile     = Reg(TilePosition())
  val triangle = Reg(UInt(11 bits)) // the next to be asked for
  val frame    = io.frame.payload

  // A box is asked for every clock; the answer of the clock before is looked at.
  val looking  = RegInit(False)
  val box      = io.store.rsp.payload
  val hit = box(15 +  4 downto 15).asUInt <= tile.tileX && box(10 + 4 downto 10).asUInt >= tile.tileX &&
    box(5 + 4 downto 5).asUInt <= tile.tileY && box(4 downto 0).asUInt >= tile.tileY
  val found  = looking && io.store.rsp.valid && hit
  val hitTriangle = Reg(UInt(10 bits))
  val hitState    = Reg(UInt(4 bits))
  val ended  = triangle === frame.triangleCount

  io.store.cmd.valid := False
  io.store.cmd.write := False
  io.store.cmd.data := 0
  io.store.cmd.address := frame.bank @@
    (U(layout.triangles, layout.bankAddressBits bits) + (triangle << 1) + 1).resize(layout.bankAddressBits)
  io.tile.valid := state === State.Tile
  io.tile.payload := tile
  io.job.valid := state === State.Hand || state === State.End
  io.job.tileEnd := state === State.End
  io.job.tileX := tile.tileX
  io.job.tileY := tile.tileY
  io.job.triangle := hitTriangle
  io.job.state := hitState
  io.frame.ready := False
  looking := False

  switch(state) {
    is(State.Idle) {
      tile.tileX := frame.x0
      tile.tileY := frame.y0
      when(io.frame.valid) { state := State.Tile }
    }
    is(State.Tile) {
      triangle := 0
      when(io.tile.ready) { state := State.Scan }
    }
    is(State.Scan) {
      // Reads are asked for come what may, so that the store's address hangs on registers alone; the one that follows a
      // hit, or the last triangle, is not looked at.
      io.store.cmd.valid := True
      when(found) {
        hitTriangle := (triangle - 1).resized
        hitState := box(31 downto 28).asUInt
        state := State.Hand
      } otherwise {
        when(io.store.cmd.fire && !ended) {
          triangle := triangle + 1
          looking := True
        }
        when(ended && !looking) { state := State.End }
      }
    }
    is(State.Hand) { when(io.job.ready) { state := State.Scan } }
    is(State.End) {
      when(io.job.ready) {
        tile.tileX := tile.tileX + 1
        state := State.Tile
        when(tile.tileX === frame.x1) {
          tile.tileX := frame.x0
          tile.tileY := tile.tileY + 1
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
