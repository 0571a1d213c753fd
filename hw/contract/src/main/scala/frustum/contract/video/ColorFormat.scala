package frustum.contract.video

/** Bits of a colour's channels at a display's pins. */
case class ColorFormat(name: String, red: Int, green: Int, blue: Int) {
  def bits: Int = red + green + blue
  def channels: Seq[Int] = Seq(red, green, blue)
  require(
    channels.forall(b => b >= 1 && b <= 8),
    s"$name: channels of $red, $green, $blue bits, from 1 to 8 each"
  )
}

object ColorFormat {
  val Rgb332 = ColorFormat("332", 3, 3, 2)
  val Rgb565 = ColorFormat("565", 5, 6, 5)
  val Rgb444 = ColorFormat("444", 4, 4, 4)
  val Rgb888 = ColorFormat("888", 8, 8, 8)
}
