package frustum.raster.setup

import frustum.contract.raster.RasterConfig
import frustum.raster.scan.{SpareRows, TileJob}
import spinal.core._
import spinal.lib._

/** A tile's job with the slot that its triangle has in the set-up engine's scratch memory and in the interpolator. */
case class SlotJob(config: RasterConfig) extends Bundle {
  val job = TileJob(config)
  val slot = UInt(log2Up(config.slots) bits)
  val known = Bool() // the slot already holds the triangle; otherwise it is to be set up there
}

/** Finds the slot of a job's triangle, one candidate per cycle, or assigns it the slot that was assigned longest ago.
  * The slots' triangles are in spare rows of the set-up's table. Needs 4 to `slots` + 5 cycles, while the job before is
  * set up.
  */
case class SlotLookup(config: RasterConfig) extends Component {
  val io = new Bundle {
    val flush = in Bool () // a new frame: the slots are empty
    val up = slave(Stream(TileJob(config)))
    val down = master(Stream(SlotJob(config)))
    val tags = master(SpareRows(config.slots, config.triangleBits))
  }
  object State extends SpinalEnum { val Idle, Search, Found, Missed = newElement() }
  val state = RegInit(State.Idle)
  val next = Reg(UInt(log2Up(config.slots) bits)) // the slot that is assigned next
  val filled = Reg(UInt(log2Up(config.slots + 1) bits)) // slots assigned in this frame
  val asked = Reg(UInt(log2Up(config.slots + 3) bits))
  // Two cycles after the request for a candidate it is known whether it is the triangle's.
  val fresh = RegNext(io.tags.free, False)
  val looked = Delay(asked, 2)
  val beyond = RegNext(RegNext(asked) === filled)
  val same = RegNext(io.tags.data === io.up.triangle)
  val judged = RegNext(fresh, False)
  val slot = Reg(UInt(log2Up(config.slots) bits))

  io.tags.address := asked.resized
  io.tags.write.valid := False
  io.tags.write.address := next
  io.tags.write.data := io.up.triangle
  io.down.valid := state === State.Found || state === State.Missed
  io.down.job := io.up.payload
  io.down.slot := slot
  io.down.known := state === State.Found
  io.up.ready := io.down.fire

  switch(state) {
    is(State.Idle) {
      asked := 0
      fresh := False
      judged := False
      slot := next
      when(io.up.valid) { state := Mux(io.up.tileEnd, State.Found, State.Search) }
    }
    is(State.Search) {
      when(io.tags.free) { asked := asked + 1 }
      when(judged) {
        when(beyond) {
          io.tags.write.valid := True
          state := State.Missed
          next := Mux(next === config.slots - 1, U(0), next + 1)
          when(filled =/= config.slots) { filled := filled + 1 }
        } elsewhen (same) {
          slot := looked.resized
          state := State.Found
        }
      }
    }
    default { when(io.down.ready) { state := State.Idle } }
  }
  when(io.flush) {
    next := 0
    filled := 0
  }
}
