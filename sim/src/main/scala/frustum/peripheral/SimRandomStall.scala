package frustum.peripheral

import spinal.core._

/** Says at random, every clock anew, whether to stall; no work of the JVM (xorshift, Marsaglia 2003).
  *
  * @param rate 256 times the probability; 0 never stalls
  * @param seed taken in the first clock after reset, not 0
  */
class SimRandomStall(rate: UInt, seed: UInt) extends Area {
  private val fresh = RegNext(False) init True
  private val state = Reg(UInt(32 bits)) init 1
  private def mix(x: UInt): UInt = {
    val a = x ^ (x |<< 13)
    val b = a ^ (a |>> 17)
    b ^ (b |<< 5)
  }
  state := Mux(fresh, seed, mix(state))
  val stall: Bool = state(23 downto 16) < rate
}
