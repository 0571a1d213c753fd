package frustum.spec

/** What the raster pipeline accepts and promises. Inputs outside are refused at the door and counted. */
object Domain {
  /** Accepted range of w: 1/w is a 16-bit mantissa with a five-bit exponent. */
  val MinW = 1.0 / 64
  val MaxW = 4096.0

  /** Largest ratio of w within one triangle for which the bounds of `docs/numbers.md` hold. */
  val MaxWRatio = 256

  /** Texture coordinates within one triangle, repeats either side of zero. */
  val MaxRepeats = 256
}
