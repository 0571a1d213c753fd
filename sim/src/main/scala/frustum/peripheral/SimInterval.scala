package frustum.peripheral

import spinal.core._
import spinal.core.sim._

/** Measures the clocks from `start` to `stop` and counts the times they are not `expected`. Only pairs that
  * begin while `counts` holds are looked at.
  */
class SimInterval(start: Bool, stop: Bool, counts: Bool, expected: UInt) extends Area {
  private val clocks = Reg(UInt(32 bits)) init 0
  private val running = RegInit(False)
  val last = Reg(UInt(32 bits)).init(0).simPublic()
  val measured = Reg(UInt(32 bits)).init(0).simPublic() // times
  val wrong = Reg(UInt(32 bits)).init(0).simPublic()
  val lastWrong = Reg(UInt(32 bits)).init(0).simPublic()

  clocks := clocks + 1
  when(stop && running) {
    running := False
    last := clocks
    measured := measured + 1
    when(clocks =/= expected.resized) {
      wrong := wrong + 1
      lastWrong := clocks
    }
  }
  when(start && counts) {
    clocks := 1
    running := True
  }
}
