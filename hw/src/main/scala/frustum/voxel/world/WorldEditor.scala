package frustum.voxel.world

import frustum.contract.voxel.VoxelConfig
import spinal.core._
import spinal.lib._
import spinal.lib.fsm._

/** Changes blocks and keeps the leaps right: an edit is taken when every word of the world's memory that it concerns is
  * what [[frustum.contract.voxel.LeapField]] says. Nothing else may read or write the memory meanwhile.
  *
  * A distance can only change in blocks that have the edited one in the directions of its group, less than `most` away.
  * Where a block is placed, they are at most the distance to it: each is compared once. Where one is removed, those
  * equal to the distance to it are set to 1, and grow again in rounds: from n to n + 1 where all neighbours in the
  * group's directions have n at least. Six cycles for a block in a round, seven if it grows, five for a neighbour. An
  * edit takes at most 63,130 cycles measured with distances of two bits in a world of 64 x 64 x 32, see docs/voxel.md.
  */
case class WorldEditor(config: VoxelConfig) extends Component {
  import WorldEditor._
  import config.leaps.{axes, bits, groups, most}
  val io = new Bundle {
    val edit = slave(Stream(BlockEdit(config)))
    val read = master(WorldReadBus(config))
    val write = master(Flow(WorldWrite(config)))
  }
  private val placeBits = config.size.logs.max + 2

  val since = Reg(UInt(2 bits)) // cycles in a state that waits for the memory
  val comes = Reg(Bool())
  val round = Reg(UInt(5 bits))
  val group = Reg(UInt(log2Up(groups).max(1) bits))
  val address = Reg(UInt(config.size.addressBits bits))
  val word = RegNext(io.read.word)
  val edited = (0 to 2).map(k => WorldPlace.coordinate(config.size, io.edit.address, k).resize(placeBits).asSInt)
  io.read.address := address
  io.write.valid := False
  io.write.address := address
  io.write.payload.word := LeapWord.of(config.leaps, io.edit.id)

  val fsm = new StateMachine {
    val idle = makeInstantEntry()
    val old, done = new State
    val item, block, memory, judge, next = new State // states of a block that the edit may concern
    val neighbour, nextTo, reach = new State // states of each of its neighbours
    val store = new State
    idle.whenIsActive {
      when(io.edit.valid) {
        address := io.edit.address
        since := 0
        goto(old)
      }
    }
    old.whenIsActive {
      since := since + 1
      when(since === Answer) {
        val (was, is) = (LeapWord.isBlock(word), io.edit.id =/= 0)
        io.write.valid := was || is
        comes := is
        round := 0
        group := 0
        goto(done)
        if (bits > 0) when(was =/= is)(goto(item))
      }
    }
    done.whenIsActive(goto(idle))
  }
  io.edit.ready := fsm.isActive(fsm.done)

  val sweep = bits > 0 generate new Area {
    import fsm._
    private def twoSided(axis: Int) = !axes.contains(axis)
    private def backward(axis: Int) = group(axes.indexOf(axis)) // the group extends along -axis

    /** The current block: the distance of the edited one from it, along each axis and as a cube's side. */
    val blocks = new Odometer((0 to 2).map(k => if (twoSided(k)) 2 * most - 2 else most - 1))
    val place = Reg(Vec(SInt(placeBits bits), 3))
    val norm = Reg(UInt(LeapWord.SideBits bits))
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

    private def inside(place: Vec[SInt]) = WorldPlace.inside(config.size, place)
    private def addressOf(place: Vec[SInt]) = WorldPlace.address(config.size, place)

    val distance = LeapWord.side(config.leaps, word, group)
    val kept = RegNextWhen(word, isActive(judge))
    val length = Reg(UInt(bits bits)) // distance less one
    val changed = CombInit(kept)
    for (g <- 0 until groups) when(group === g)(changed(g * bits, bits bits) := length.asBits)

    item.whenIsActive {
      for (k <- 0 to 2) place(k) := edited(k) - away(k)
      val lengths = away.map(a => Mux(a.msb, -a, a).asUInt.resize(LeapWord.SideBits))
      norm := lengths.reduceBalancedTree((a, b) => Mux(a > b, a, b))
      goto(block)
    }
    block.whenIsActive {
      address := addressOf(place)
      since := 0
      when(inside(place))(goto(memory)).otherwise(goto(next))
    }
    memory.whenIsActive {
      since := since + 1
      when(since === Answer - 1)(goto(judge))
    }
    judge.whenIsActive {
      goto(next)
      when(!LeapWord.isBlock(word)) {
        when(comes) {
          length := (norm - 1).resized
          when(norm < distance)(goto(store))
        } elsewhen (round === 0) {
          length := 0
          when(norm === distance)(goto(store))
        } elsewhen (distance === round) {
          length := round.resized
          nearby.step() // from here to the first neighbour
          goto(neighbour)
        }
      }
    }
    neighbour.whenIsActive {
      for (k <- 0 to 2) beside(k) := place(k) + step(k)
      goto(nextTo)
    }
    nextTo.whenIsActive {
      since := 0
      address := addressOf(beside)
      goto(reach)
    }
    reach.whenIsActive {
      since := since + 1
      when(since === Answer || !inside(beside)) {
        nearby.step()
        goto(neighbour)
        when(nearby.over)(goto(store))
        when(inside(beside) && (LeapWord.isBlock(word) || distance < round))(goto(next))
      }
    }
    store.whenIsActive {
      address := addressOf(place)
      goto(next)
    }
    next.whenIsActive {
      nearby.clear()
      blocks.step()
      goto(item)
      when(blocks.over) {
        round := round + 1
        when(comes || round === most - 1) {
          round := 0
          group := group + 1
          when(group === groups - 1)(goto(done))
        }
      }
    }
    val stores = RegNext(isActive(store)) init False
    when(stores) {
      io.write.valid := True
      io.write.payload.word := changed
    }
  }
}

object WorldEditor {

  /** Cycles from an address in its register to the word in its own. */
  private val Answer = WorldReadBus.Latency + 1
}
