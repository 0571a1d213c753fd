package frustum.mutation

import spinal.core._

/** A port of a unit. */
final case class UnitPort(name: String, width: Int, isInput: Boolean)

object UnitPort {

  /** Ports of a unit that was elaborated, without clock and reset. */
  def of(unit: Component): Seq[UnitPort] =
    unit.getOrdredNodeIo.toSeq.map(p => UnitPort(p.getName(), p.getBitsWidth, p.isInput))
      .filterNot(p => Set("clk", "reset")(p.name))
}

/** The netlist with all of a unit's mutants: `mutsel` tells which one it is, 0 none. */
final class MutantNetlist(name: String, ports: Seq[UnitPort], file: String) extends BlackBox {
  setDefinitionName(name)
  val clk, reset = in Bool ()
  val mutsel = in UInt (MutantNetlist.SelectBits bits)
  val port: Map[String, Bits] = ports.map { p =>
    val bits = Bits(p.width bits).setName(p.name)
    p.name -> (if (p.isInput) in(bits) else out(bits))
  }.toMap
  mapClockDomain(clock = clk, reset = reset)
  noIoPrefix()
  addRTLPath(file)
}

object MutantNetlist {
  val SelectBits = 12
  val Most: Int = (1 << SelectBits) - 1
}
