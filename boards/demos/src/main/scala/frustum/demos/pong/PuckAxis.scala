package frustum.demos.pong

import spinal.core._

/** One axis of the puck: position, unsigned speed and direction. `move` adds the speed, a cycle later `bound` sets a
  * position beyond a limit to the limit and turns; `turn` takes a new speed and direction instead.
  */
case class PuckAxis(low: Int, high: Int, start: Int) extends Component {
  val io = new Bundle {
    val restart, move, bound, turn = in Bool ()
    val newSpeed = in UInt (PongRules.SpeedBits bits)
    val newPositive = in Bool ()
    val position = out SInt (12 bits)
    val speed = out UInt (PongRules.SpeedBits bits)
    val atHigh = out Bool () // at the high limit or beyond it, to be used with `bound`
  }
  private val furthest = scala.math.max(high.abs, low.abs) + (1 << PongRules.SpeedBits)
  require(furthest < (1 << 11), s"puck from $low to $high leaves 12 bits")
  val position = Reg(SInt(12 bits)) init start
  val speed = Reg(UInt(PongRules.SpeedBits bits)) init PongRules.StartSpeed
  val positive = RegInit(True)
  val over = position > high
  val under = position < low

  when(io.move)(position := Mux(positive, position + speed.intoSInt, position - speed.intoSInt))
  when(io.bound) {
    when(over) { position := high; positive := False }
    when(under) { position := low; positive := True }
  }
  when(io.turn) {
    speed := io.newSpeed
    positive := io.newPositive
  }
  when(io.restart) {
    position := start
    speed := PongRules.StartSpeed
    positive := True
  }
  io.position := position
  io.speed := speed
  io.atHigh := positive && position >= high
}
