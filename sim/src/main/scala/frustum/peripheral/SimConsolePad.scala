package frustum.peripheral

import frustum.demos.pad.ConsolePadPins
import spinal.core._
import spinal.core.sim._
import scala.collection.mutable.ArrayBuffer

/** A console's pad at the wires of a running simulation. It shows a bit of its answer at each falling edge of SCK and
  * takes one of the command at each rising edge, least significant bit first, while `att` is low.
  *
  * @param answer bytes after the first, which is ones; without them there is no pad, and the wire is pulled up.
  *   Beyond its end: ones
  */
final class SimConsolePad(pins: ConsolePadPins, clock: ClockDomain) {
  var answer: Seq[Int] = Nil

  /** Bytes of the command that came last. */
  val asked = ArrayBuffer.empty[Int]

  /** Shortest and longest time between two falling edges within a byte, clocks. */
  var shortest, longest = 0L

  /** Bytes that a question must have for the whole of the answer: three, and two for each of as many as the id's low
    * digit says.
    */
  def due: Int = 3 + 2 * (answer.headOption.getOrElse(0) & 15)

  private var bits = 0
  private var selected = false
  private var sck = true
  private var clocks, lastFall: Long = 0
  pins.dat #= true

  clock.onSamplings {
    clocks += 1
    val (att, now) = (!pins.att.toBoolean, pins.sck.toBoolean)
    if (att && !selected) { bits = 0; asked.clear() }
    if (!att) pins.dat #= true
    else if (sck && !now) {
      val byte = (0xff +: answer).lift(bits / 8).getOrElse(0xff)
      pins.dat #= (byte >> bits % 8 & 1) == 1
      if (bits % 8 > 0) {
        shortest = if (shortest == 0) clocks - lastFall else shortest.min(clocks - lastFall)
        longest = longest.max(clocks - lastFall)
      }
      lastFall = clocks
    } else if (!sck && now) {
      if (bits % 8 == 0) asked += 0
      if (pins.cmd.toBoolean) asked(asked.length - 1) |= 1 << bits % 8
      bits += 1
    }
    selected = att
    sck = now
  }
}
