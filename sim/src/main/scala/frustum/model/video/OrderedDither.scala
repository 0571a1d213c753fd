package frustum.model.video

import frustum.contract.video.{Bayer, ColorFormat}

/** Model of [[frustum.video.OrderedDither]]. */
object OrderedDither {

  /** An 8-bit channel in `bits` at pixel (x, y): 0 and 255 stay the ends of the range. */
  def channel(value: Int, bits: Int, x: Int, y: Int): Int = {
    val lost = 8 - bits
    (value - (value >> bits) + (if (lost == 0) 0 else Bayer.threshold(x, y, lost))) >> lost
  }

  /** 24-bit colour to the format's channels, red in the highest bits. */
  def apply(rgb: Int, format: ColorFormat, x: Int, y: Int): Int =
    format.channels.zip(Seq(16, 8, 0)).foldLeft(0) { case (word, (bits, shift)) =>
      word << bits | channel(rgb >> shift & 255, bits, x, y)
    }
}
