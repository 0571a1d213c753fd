package frustum.model.game

import frustum.spec.{IntVector, RayMotion}

/** Buttons of the paddle during one tick. */
case class PongButtons(
    up: Boolean = false,
    down: Boolean = false,
    left: Boolean = false,
    right: Boolean = false
)

/** Rules of 3-D pong, one `tick` at a time: paddle, puck, bounce or catch, score. */
class PongGame {
  private val limit     = Seq(300, 220)
  private val reach     = Seq(270, 190)
  private var place     = Array(0, 0, 320)
  private var forward   = Array(true, true, true)
  private var speed     = Array(3, 3, 3)
  private var paddleAt  = Array(0, 0)
  var score             = 0
  var missed            = false
  def won: Boolean      = score >= 63
  def puck: IntVector   = IntVector(place(0), place(1), place(2))
  def paddle: IntVector = IntVector(paddleAt(0), paddleAt(1), 640)
  def motion: RayMotion = RayMotion(Seq(puck), Seq(paddle))

  def tick(b: PongButtons): Unit = if (!missed && !won) {
    for ((axis, plus, minus) <- Seq((0, b.right, b.left), (1, b.up, b.down))) {
      val step = (if (plus) 4 else 0) - (if (minus) 4 else 0)
      paddleAt(axis) = (paddleAt(axis) + step).max(-reach(axis)).min(reach(axis))
    }
    for (a <- 0 to 2) place(a) += (if (forward(a)) speed(a) else -speed(a))
    for (a <- 0 to 1 if place(a).abs > limit(a)) {
      place(a) = limit(a) * place(a).sign
      forward(a) = !forward(a)
    }
    if (place(2) < 20) { place(2) = 20; forward(2) = true }
    if (place(2) >= 620) {
      val d = (0 to 1).map(a => place(a) - paddleAt(a))
      place(2) = 620
      if (d.forall(_.abs < 50)) {
        for (a <- 0 to 1) { speed(a) = d(a).abs / 2; forward(a) = d(a) >= 0 }
        forward(2) = false
        speed(2) += 1
        score += 1
      } else missed = true
    }
  }
}
