package frustum.demos.voxel

import frustum.contract.voxel.{BlockTable, VoxelConfig}
import frustum.voxel.world.{BlockFlags, WorldReadBus}
import spinal.core._
import spinal.lib._

/** Whether a player's body, with its feet at some place, touches a block that can be pointed at: reads the blocks that the body reaches into, at most
  * twelve, four clocks each. What lies outside of the world is air. The model is `frustum.model.demos.voxel.VoxelPlayer.touches`.
  *
  * `start` takes the place; `touches` and the blocks `low` to `high` hold from `done` to the next start.
  */
case class BodyProbe(c: VoxelConfig, kinds: BlockTable) extends Component {
  val io = new Bundle {
    val start = in Bool ()
    val feet = in Vec (SInt(VoxelPose.width(c) bits), 3)
    val read = master(WorldReadBus(c))
    val low, high = out Vec (SInt(c.blockBits bits), 3)
    val done = out Bool ()
    val touches = out Bool ()
  }
  val low, high, at = Reg(Vec(SInt(c.blockBits bits), 3))
  val busy, touches = RegInit(False)
  val phase = Reg(UInt(2 bits)) // address, memory, word, next
  val inside = (0 to 2).map(k => !at(k).msb && (at(k) >> c.size.logs(k)) === 0).reduce(_ && _)
  val address = RegNext(Cat((2 to 0 by -1).map(k => at(k)(c.size.logs(k) - 1 downto 0))).asUInt)
  val word = RegNext(io.read.word)
  val solid = RegNext(inside) && word.msb &&
    BlockFlags(kinds).where(_.selectable)(word(BlockTable.IdBits - 1 downto 0).asUInt)
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
    phase := 0
    touches := False
  } elsewhen (busy) {
    phase := phase + 1
    when(phase === 3) {
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
  io.done := RegNext(busy && phase === 3 && over.andR && !io.start) init False
}
