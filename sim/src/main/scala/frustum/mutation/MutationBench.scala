package frustum.mutation

import spinal.core._

/** Drives a netlist through a plan by itself, so that the simulator need not be waited on: steps and expected values
  * lie in memories. `failed` once a value is wrong or nothing more comes, `done` at the end; both stay.
  */
final class MutationBench(plan: MutationPlan, ports: Seq[UnitPort], file: String) extends Component {
  val io = new Bundle {
    val select = in UInt (MutantNetlist.SelectBits bits)
    val failed, done = out Bool ()
  }
  private val netlist = new MutantNetlist(plan.name, ports, file)
  private val (inputs, outputs) = ports.partition(_.isInput)
  netlist.mutsel := io.select
  plan.steps.flatMap(s => s.inputs.keys ++ s.expect.keys).distinct.foreach(name =>
    require(ports.exists(_.name == name), s"${plan.name} has no port $name")
  )
  private def high(name: String): Bool = netlist.port(name).orR

  // A step: whether it waits, its inputs, what is looked at, what should be there.
  private val widthIn = inputs.map(_.width).sum
  private val widthOut = outputs.map(_.width).sum
  private val steps = Mem(Bits(1 + widthIn + 2 * widthOut bits), plan.steps.length)
  steps.initBigInt(plan.steps.map { s =>
    val expected = pack(outputs, p => s.expect.getOrElse(p.name, BigInt(0)))
    val looked = pack(outputs, p => if (s.expect.contains(p.name)) ones(p.width) else BigInt(0))
    val driven = pack(inputs, p => s.inputs.getOrElse(p.name, BigInt(0)))
    (((BigInt(if (s.waits) 1 else 0) << widthIn | driven) << widthOut | looked) << widthOut) | expected
  })
  private val at = Reg(UInt(log2Up(plan.steps.length + 1) bits)) init 0
  private val ended = at === plan.steps.length
  private val word = steps.readAsync(at.resize(log2Up(plan.steps.length)))
  private val step = ended ? B(0, widthOf(word) bits) | word
  private val waits = step.msb

  private val lots = Reg(UInt(32 bits)) init 0x2545f491L
  lots := lots ^ (lots |<< 13) ^ ((lots ^ (lots |<< 13)) |>> 17) // an xorshift without its last step: lots enough
  inputs.foldLeft(2 * widthOut + widthIn) { (end, p) =>
    val value = step(end - p.width, p.width bits)
    netlist.port(p.name) := (if (plan.stalled.contains(p.name)) (lots(3) || lots(18)).asBits else value)
    end - p.width
  }
  private val moves = !ended && !(waits && !plan.waitsFor.fold(True)(high))
  when(moves)(at := at + 1)

  private val shown =
    if (outputs.isEmpty) B(0, 1 bits) else Cat(outputs.reverse.map(p => netlist.port(p.name)))
  private val wrongShown = ((shown ^ step.take(widthOut)) & step(widthOut, widthOut bits)).orR

  private val wrongEvent, moved = Bool()
  private val allLeft = Bool()
  plan.event match {
    case Some((when_, values)) =>
      val read = values.map(name => ports.find(_.name == name).get)
      val width = read.map(_.width).sum
      val events = Mem(Bits(2 * width bits), plan.events.length + 1)
      events.initBigInt(plan.events.map { e =>
        val byName = values.zip(e).toMap
        pack(read, p => byName(p.name).fold(BigInt(0))(_ => ones(p.width))) << width |
          pack(read, p => byName(p.name).getOrElse(BigInt(0)) & ones(p.width))
      } :+ BigInt(0))
      val n = Reg(UInt(log2Up(plan.events.length + 2) bits)) init 0
      val leaves = when_.map(high).reduce(_ && _)
      val should = events.readAsync(n.resize(log2Up(plan.events.length + 1)))
      val is = Cat(read.reverse.map(p => netlist.port(p.name)))
      allLeft := n === plan.events.length
      wrongEvent := leaves && (allLeft || ((is ^ should.take(width)) & should.drop(width)).orR)
      when(leaves && !allLeft)(n := n + 1)
      moved := leaves
    case None =>
      allLeft := True
      wrongEvent := False
      moved := False
  }

  private val inside = Reg(UInt(8 bits)) init 0
  private val wrongBusy = plan.busy.fold(False)(port => high(port) =/= (inside =/= 0))
  inside := inside + (moves && waits).asUInt - moved.asUInt

  private val still = Reg(UInt(log2Up(MutationBench.Patience + 1) bits)) init 0
  still := still + 1
  when(moves || moved)(still := 0)
  private val finished = ended && allLeft
  private val failed, done = RegInit(False)
  when(finished && still === MutationBench.Rest)(done := True)
  when(wrongShown || wrongEvent || wrongBusy || still === MutationBench.Patience && !finished)(failed := True)
  io.failed := failed
  io.done := done

  private def ones(width: Int): BigInt = (BigInt(1) << width) - 1

  /** The first port in the highest bits. */
  private def pack(of: Seq[UnitPort], value: UnitPort => BigInt): BigInt =
    of.foldLeft(BigInt(0))((all, p) => all << p.width | value(p) & ones(p.width))
}

object MutationBench {

  /** Clocks without any progress after which a unit hangs, and after which nothing more comes of one that has done all.
    */
  val Patience = 2000
  val Rest = 64
}
