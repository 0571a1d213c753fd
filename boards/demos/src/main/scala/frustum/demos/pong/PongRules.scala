package frustum.demos.pong

import frustum.contract.arithmetic.IntVector

/** Rules of 3-D pong, in the units of [[PongScene]] and in ticks, one in `FramesPerTick` frames. */
object PongRules {
  val PuckRadius = 20
  val PuckStart = IntVector(0, 0, 320)

  /** The puck's centre stays between these on each axis; at the far end of z is the paddle's wall. */
  val PuckLow = IntVector(-300, -220, 20)
  val PuckHigh = IntVector(300, 220, 620)

  /** Of each axis at the start, in the positive direction; speeds are magnitudes of `SpeedBits`. */
  val StartSpeed = 3
  val SpeedBits = 7

  val PaddleStep = 4
  val PaddleX = 270
  val PaddleY = 190

  /** Half of the paddle's size: caught when the puck's centre is less than this from the paddle's on both axes. */
  val Reach = 50
  val WinScore = 63
  require(
    StartSpeed + WinScore < (1 << SpeedBits),
    s"z speed $StartSpeed + $WinScore exceeds $SpeedBits bits"
  )

  val FramesPerTick = 2
}
