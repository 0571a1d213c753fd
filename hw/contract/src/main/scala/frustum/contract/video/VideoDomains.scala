package frustum.contract.video

import frustum.contract.ValidFor

/** Ranges within which the methods of the displays keep their error bounds. */
object VideoDomains {
  val DitherBits = ValidFor("dither", "dither-bits", "bits of a channel", 1, 8, 9, "of 255, mean of 4 x 4")
}
