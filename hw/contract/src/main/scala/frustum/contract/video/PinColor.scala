package frustum.contract.video

import scala.math.{pow, round}

/** Colours of eight bits per channel at pins of fewer: the upper bits, or with a gamma above 1 c^(1/gamma), rounded. */
final case class PinColor(format: ColorFormat, gamma: Double = 1) {
  require(gamma >= 1 && gamma <= 4, s"a gamma of $gamma; 1 to 4 are supported")

  def channel(value: Int, bits: Int): Int =
    if (gamma == 1) value >> 8 - bits else round(pow(value / 255.0, 1 / gamma) * ((1 << bits) - 1)).toInt

  /** Of 0xRRGGBB. */
  def apply(rgb: Int): Int =
    channel(rgb >> 16 & 255, format.red) << format.green + format.blue |
      channel(rgb >> 8 & 255, format.green) << format.blue | channel(rgb & 255, format.blue)
}
