package frustum.demos.pong

import spinal.core._

/** The paddle's centre: a step per tick in each direction that is pressed, diagonals too, within its reach. */
case class Paddle() extends Component {
  val io = new Bundle {
    val restart, move = in Bool ()
    val buttons = in(PongButtons())
    val x, y = out SInt (12 bits)
  }
  private def axis(less: Bool, more: Bool, limit: Int) = {
    val at = Reg(SInt(12 bits)) init 0
    when(io.move && (less ^ more)) {
      at := Mux(more, at + PongRules.PaddleStep, at - PongRules.PaddleStep)
      when(more && at > limit - PongRules.PaddleStep)(at := limit)
      when(less && at < PongRules.PaddleStep - limit)(at := -limit)
    }
    when(io.restart)(at := 0)
    at
  }
  io.x := axis(io.buttons.left, io.buttons.right, PongRules.PaddleX)
  io.y := axis(io.buttons.down, io.buttons.up, PongRules.PaddleY)
}
