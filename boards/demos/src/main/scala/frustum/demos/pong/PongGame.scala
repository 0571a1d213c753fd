package frustum.demos.pong

import frustum.demos.pong.PongRules._
import spinal.core._
import spinal.lib._

/** 3-D pong: a tick moves the paddle, moves the puck, computes bounce or catch, and counts, one after the other in
  * `PongGame.TickClocks`; between ticks nothing changes. A miss or the last catch ends the game until all buttons are
  * pressed at once, or reset.
  */
case class PongGame() extends Component {
  import PongGame._
  val io = new Bundle {
    val tick = in Bool ()
    val buttons = in(PongButtons()) // constant during a tick
    val puck = out(Vec(SInt(12 bits), 3))
    val paddleX = out SInt (12 bits)
    val paddleY = out SInt (12 bits)
    val tens, ones = out UInt (4 bits) // digits of the score
    val won, lost = out Bool ()
    val caught = out Bool () // the puck was caught at the last tick
  }
  val won, lost, caught = RegInit(False)
  val tens, ones = Reg(UInt(4 bits)) init 0
  val restart = io.tick && io.buttons.restart
  val step =
    History(io.tick && !io.buttons.restart && !won && !lost, 0 to TickClocks - 1, init = False)

  val paddle = Paddle()
  paddle.io.restart := restart
  paddle.io.buttons := io.buttons
  paddle.io.move := step(Move)
  val puck = Seq.tabulate(3)(a => PuckAxis(PuckLow(a), PuckHigh(a), PuckStart(a)))
  for (p <- puck) {
    p.io.restart := restart
    p.io.move := step(Move)
    p.io.bound := step(Bound)
  }

  val atWall = RegNextWhen(puck(2).io.atHigh, step(Bound)) init False
  val off = Vec(RegNext(puck(0).io.position - paddle.io.x), RegNext(puck(1).io.position - paddle.io.y))
  val near = Vec(off.map(d => RegNext(d.abs < Reach)))
  val catches = step(Decide) && atWall && near.andR
  for (a <- 0 to 1) {
    puck(a).io.turn := catches
    puck(a).io.newSpeed := (off(a).abs |>> 1).resized
    puck(a).io.newPositive := !off(a).msb
  }
  puck(2).io.turn := catches
  puck(2).io.newSpeed := puck(2).io.speed + 1
  puck(2).io.newPositive := False

  when(io.tick)(caught := False)
  when(step(Decide) && atWall) {
    caught := near.andR
    lost := !near.andR
  }
  when(catches) {
    ones := ones + 1
    when(ones === 9) { ones := 0; tens := tens + 1 }
    won := tens === (WinScore - 1) / 10 && ones === (WinScore - 1) % 10
  }
  when(restart) {
    won := False
    lost := False
    tens := 0
    ones := 0
  }
  io.puck := Vec(puck.map(_.io.position))
  io.paddleX := paddle.io.x
  io.paddleY := paddle.io.y
  io.tens := tens
  io.ones := ones
  io.won := won
  io.lost := lost
  io.caught := caught
}

object PongGame {

  // Steps of a tick: all move, the puck turns at the walls; its distance from the paddle is known, then whether that
  // is near.
  private val Move = 0
  private val Bound = Move + 1
  private val Away = Bound + 1
  private val Near = Away + 1
  private val Decide = Near + 1
  val TickClocks = Decide + 1
}
