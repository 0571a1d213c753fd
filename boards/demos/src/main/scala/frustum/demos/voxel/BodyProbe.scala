package frustum.demos.voxel

import frustum.contract.voxel.{BlockTable, VoxelConfig}
import frustum.voxel.world.{BlockFlags, LeapWord, WorldPlace, WorldReadBus}
import spinal.core._
import spinal.lib._

/** Whether a player's body, with its feet at some place, touches a selectable block: reads the blocks that the body
  * reaches into, at most twelve, four cycles each. Outside the world is air. The model is
  * `frustum.model.demos.voxel.VoxelPlayer.touches`.
  *
  * `start` takes the place; `touches` and the blocks `low` to `high` hold from `done` to the next start.
  */
case class BodyProbe(config: VoxelConfig, kinds: BlockTable) extends Component {
  import BodyProbe._
  val io = new Bundle {
    val start = in Bool ()
    val feet = in Vec (SInt(VoxelPose.width(config) bits), 3)
    val read = master(WorldReadBus(config))
    val low, high = out Vec (SInt(config.blockBits bits), 3)
    val done = out Bool ()
    val touches = out Bool ()
  }
  val low, high, at = Reg(Vec(SInt(config.blockBits bits), 3))
  val busy, touches = RegInit(False)
  val since = Reg(UInt(2 bits)) // cycles since the place is stable
  val address = RegNext(WorldPlace.address(config.size, at))
  val word = RegNext(io.read.word)
  val inside = RegNext(WorldPlace.inside(config.size, at))
  val solid = inside && LeapWord.isBlock(word) && BlockFlags(kinds).where(_.selectable)(LeapWord.id(word))
  val over = Vec((0 to 2).map(k => at(k) === high(k)))

  private def block(from: SInt, by: Int): SInt = (from + by) >> 8
  when(io.start) {
    for (k <- 0 to 2) {
      val (first, end) = VoxelRules.body(k)
      low(k) := block(io.feet(k), first)
      high(k) := block(io.feet(k), end - 1)
      at(k) := block(io.feet(k), first)
    }
    busy := True
    since := 0
    touches := False
  } elsewhen (busy) {
    since := since + 1
    when(since === Answer) {
      touches setWhen solid
      at(2) := at(2) + 1
      when(over(2)) {
        at(2) := low(2)
        at(1) := at(1) + 1
        when(over(1)) {
          at(1) := low(1)
          at(0) := at(0) + 1
        }
      }
      when(over.andR)(busy := False)
    }
  }
  io.read.address := address
  io.low := low
  io.high := high
  io.touches := touches
  io.done := RegNext(busy && since === Answer && over.andR && !io.start) init False
}

object BodyProbe {

  /** Cycles from a place to its word: address, memory and word have a register each. */
  private val Answer = 1 + WorldReadBus.Latency + 1
}
