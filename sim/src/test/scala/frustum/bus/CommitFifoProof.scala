package frustum.bus

import frustum.harness.{Formal, Prover}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.formal._
import spinal.lib._

/** The FIFO with counters beside it that follow the rules: words pushed, made visible, taken. */
class CommitFifoClaims(depth: Int, margin: Int) extends Component {
  val fifo = FormalDut(CommitFifo(depth, margin))
  val io = fifo.io
  val push = anyseq(cloneOf(io.push))
  val commit, rollback, ready = anyseq(Bool())
  assumeInitial(clockDomain.isResetActive)
  io.push << push
  io.commit := commit
  io.rollback := rollback
  io.pop.ready := ready
  assume(!rollback || !commit && !push.valid) // a rollback goes alone

  val visible, speculative = Reg(UInt(log2Up(depth) + 2 bits)) init 0
  val pushes = push.valid && !io.full
  val pops = io.pop.fire
  visible := visible - pops.asUInt + Mux(commit, speculative, U(0).resized)
  speculative := Mux(commit || rollback, U(0).resized, speculative) + pushes.asUInt

  // What the pointers have to do with the counters: without this, induction starts from states that are never reached.
  val stored = visible +^ speculative - io.pop.valid.asUInt
  assert(stored < depth)
  assert(!io.pop.valid || visible =/= 0)
  assert((fifo.committed.pull() - fifo.fetched.pull()).resize(
    visible.getWidth
  ) +^ io.pop.valid.asUInt === visible.resized)
  assert((fifo.written.pull() - fifo.committed.pull()).resize(speculative.getWidth) === speculative)
  val free = U(depth - 1) - stored
  when(pastValid && !past(clockDomain.isResetActive)) {
    assert(io.full === past(stored >= depth - 2))
    assert(fifo.late.pull() === past(free).resized)
    assert(io.room === past(fifo.late.pull() >= margin))
  }
}

/** A reader is promised what a Stream promises, and words that were committed alone. */
class CommitFifoControl(depth: Int, margin: Int) extends CommitFifoClaims(depth, margin) {
  io.pop.formalAssertsMaster()
}

/** One word, picked at any time, comes out in its turn unless it is rolled back. */
class CommitFifoOrder(depth: Int, margin: Int) extends CommitFifoClaims(depth, margin) {
  val pick = anyseq(Bool())
  val watched, certain = RegInit(False)
  val word = Reg(Bits(16 bits))
  val ahead = Reg(UInt(visible.getWidth + 1 bits))
  val memory = fifo.rework(new Area {
    val address = in UInt (log2Up(depth) bits)
    val data = out(fifo.memory.readAsync(address))
  })
  memory.address := (fifo.fetched.pull() + ahead - io.pop.valid.asUInt).resized
  when(!watched && pick && pushes) {
    watched := True
    certain := False
    word := push.payload
    ahead := visible +^ speculative - pops.asUInt
  }
  when(watched) {
    when(commit)(certain := True)
    when(pops)(ahead := ahead - 1)
    when(rollback && !certain)(watched := False)
    when(pops && ahead === 0) {
      assert(certain && io.pop.payload === word)
      watched := False
    }
    // where it is meanwhile
    assert(ahead < visible +^ speculative)
    assert(certain === ahead < visible)
    when(io.pop.valid && ahead === 0) { assert(io.pop.payload === word) } otherwise {
      assert(memory.data === word)
    }
  }
}

class CommitFifoProof extends AnyFunSuite {
  test("only committed words are offered, steadily; full and room tell the truth", Formal) {
    Prover.prove("CommitFifoControl", depth = 3)(new CommitFifoControl(8, 3))
  }
  test("words come out as they went in", Formal) {
    Prover.prove("CommitFifoOrder", depth = 3)(new CommitFifoOrder(8, 3))
  }
}
