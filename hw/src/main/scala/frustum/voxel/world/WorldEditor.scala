package frustum.voxel.world

import frustum.contract.voxel.VoxelConfig
import spinal.core._
import spinal.lib._

/** Changes blocks and keeps the leaps right: an edit is taken when every word of the world's memory that it concerns is what
  * [[frustum.contract.voxel.LeapField]] says. Nothing else may read or write the memory meanwhile.
  *
  * A distance can only change in blocks that have the edited one in the directions of its group, less than `most` away.
  * Where a block comes, they are at most the way to it: one look at each. Where one goes, those that are just
  * the way to it fall to 1, and grow again in rounds: from n to n + 1 where all neighbours in the group's directions have n at
  * least. Six clocks for a block in a round, seven if it grows, five for a neighbour. An edit takes at most 63,130 clocks as seen with
  * distances of two bits in a world of 64 x 64 x 32, see docs/voxel.md.
  */
case class WorldEditor(c: VoxelConfig) extends Component {
  import c.leaps.{axes, bits, groups, most, payload, wordBits}
  val io = new Bundle {
    val edit = slave(Stream(BlockEdit(c)))
    val read = master(WorldReadBus(c))
    val write = master(Flow(WorldWrite(c)))
  }
  private val logs = c.size.logs
  private val placeBits = logs.max + 2

  object State extends SpinalEnum {
    val idle, old, item, block, memory, word, neighbour, nextTo, reach, seen, next, done = newElement()
  }
  val state = RegInit(State.idle)
  val since = Reg(UInt(2 bits)) // clocks in a state that waits for the memory
  val comes = Reg(Bool())
  val round = Reg(UInt(5 bits))
  val group = Reg(UInt(log2Up(groups).max(1) bits))
  val address = Reg(UInt(c.size.addressBits bits))
  val word = RegNext(io.read.word)
  val edited = (0 to 2).map { k =>
    io.edit.address(logs.drop(k).sum - 1 downto logs.drop(k + 1).sum).resize(placeBits).asSInt
  }
  io.read.address := address
  io.write.valid := False
  io.write.address := address
  io.write.payload.word := (io.edit.id =/= 0) ? (B(
    1 << payload,
    wordBits bits
  ) | io.edit.id.asBits.resize(wordBits)) | B(0, wordBits bits)
  io.edit.ready := state === State.done

  when(state === State.idle && io.edit.valid) {
    address := io.edit.address
    since := 0
    state := State.old
  }
  when(state === State.old) {
    since := since + 1
    when(since === 2) {
      val (was, is) = (word.msb, io.edit.id =/= 0)
      io.write.valid := was || is
      comes := is
      round := 0
      group := 0
      state := (if (bits == 0) State.done() else Mux(was === is, State.done(), State.item()))
    }
  }
  when(state === State.done)(state := State.idle)

  val sweep = bits > 0 generate new Area {
    private def twoSided(axis: Int) = !axes.contains(axis)
    private def backward(axis: Int) = group(axes.indexOf(axis)) // the group looks along -axis

    /** The block looked at: how far the edited one is from it, along each axis and as a cube's side. */
    val blocks = new Odometer((0 to 2).map(k => if (twoSided(k)) 2 * most - 2 else most - 1))
    val place = Reg(Vec(SInt(placeBits bits), 3))
    val norm = Reg(UInt(5 bits))
    val away = Vec((0 to 2).map { k =>
      val at = blocks.at(k).resize(placeBits).asSInt
      if (twoSided(k)) at - (most - 1) else Mux(backward(k), -at, at)
    })

    /** Neighbours: here and ahead, or, where the group has both signs, behind as well. */
    val nearby = new Odometer((0 to 2).map(k => if (twoSided(k)) 2 else 1))
    val beside = Reg(Vec(SInt(placeBits bits), 3))
    val step = Vec((0 to 2).map { k =>
      val behind = if (twoSided(k)) nearby.at(k)(1) else backward(k)
      Mux(nearby.at(k) === 0, S(0, 2 bits), Mux(behind, S(-1, 2 bits), S(1, 2 bits)))
    })

    private def inside(p: Vec[SInt]) = (0 to 2).map(k => !p(k).msb && (p(k) >> logs(k)) === 0).reduce(_ && _)
    private def addressOf(p: Vec[SInt]) = Cat((2 to 0 by -1).map(k => p(k)(logs(k) - 1 downto 0))).asUInt

    val slices = word(groups * bits - 1 downto 0).subdivideIn(groups slices)
    val distance = (if (groups == 1) slices(0) else slices(group)).asUInt.resize(5) + 1
    val kept = RegNextWhen(word, state === State.word)
    val length = Reg(UInt(bits bits)) // less one
    val changed = CombInit(kept)
    for (g <- 0 until groups) when(group === g)(changed(g * bits, bits bits) := length.asBits)

    switch(state) {
      is(State.item) {
        for (k <- 0 to 2) place(k) := edited(k) - away(k)
        norm := away.map(a => Mux(a.msb, -a, a).asUInt.resize(5)).reduceBalancedTree((a, b) => Mux(a > b, a, b))
        state := State.block
      }
      is(State.block) {
        address := addressOf(place)
        since := 0
        state := Mux(inside(place), State.memory(), State.next())
      }
      is(State.memory) {
        since := since + 1
        when(since === 1)(state := State.word)
      }
      is(State.word) {
        state := State.next
        when(!word.msb) {
          when(comes) {
            length := (norm - 1).resized
            when(norm < distance)(state := State.seen)
          } elsewhen (round === 0) {
            length := 0
            when(norm === distance)(state := State.seen)
          } elsewhen (distance === round) {
            length := round.resized
            nearby.step() // from here to the first neighbour
            state := State.neighbour
          }
        }
      }
      is(State.neighbour) {
        for (k <- 0 to 2) beside(k) := place(k) + step(k)
        state := State.nextTo
      }
      is(State.nextTo) {
        since := 0
        address := addressOf(beside)
        state := State.reach
      }
      is(State.reach) {
        since := since + 1
        when(since === 2 || !inside(beside)) {
          nearby.step()
          state := State.neighbour
          when(nearby.over)(state := State.seen)
          when(inside(beside) && (word.msb || distance < round))(state := State.next)
        }
      }
      is(State.seen) {
        address := addressOf(place)
        state := State.next
      }
      is(State.next) {
        nearby.clear()
        blocks.step()
        state := State.item
        when(blocks.over) {
          round := round + 1
          when(comes || round === most - 1) {
            round := 0
            group := group + 1
            when(group === groups - 1)(state := State.done)
          }
        }
      }
    }
    val store = RegNext(state === State.seen) init False
    when(store) {
      io.write.valid := True
      io.write.payload.word := changed
    }
  }
}
