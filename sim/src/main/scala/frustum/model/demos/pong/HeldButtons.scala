package frustum.model.demos.pong

/** Model of [[frustum.demos.pad.Buttons]] as pong has them: looked at in each blank; what two looks in a row agree on
  * holds.
  */
final class HeldButtons {
  private var (before, now) = (PongButtons(), PongButtons())

  /** A look; gives what holds after it. */
  def look(pins: PongButtons): PongButtons = {
    def agreed(of: PongButtons => Boolean) = of(now) && (of(pins) || of(before)) || of(pins) && of(before)
    now = PongButtons(agreed(_.up), agreed(_.down), agreed(_.left), agreed(_.right))
    before = pins
    now
  }
}
