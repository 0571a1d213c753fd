package frustum.contract.raster

/** The inputs that the raster pipeline accepts, and its bounds. Validation refuses other inputs and counts them. */
object Domain {

  /** Accepted range of w: 1/w is a 16-bit mantissa with a five-bit exponent. */
  val MinW = 1.0 / 64
  val MaxW = 4096.0

  /** Largest ratio of w within one triangle for which the bounds of `docs/numbers.md` hold. */
  val MaxWRatio = 256

  /** A triangle's texture coordinates span less than this many repeats; less by two from the driver, which subtracts
    * even numbers.
    */
  val MaxRepeats = 256

  /** A mesh's triangle may span this many: the driver cuts it. */
  val MaxMeshRepeats = 1024.0

  /** Twice the area, in 1/256 pixel^2, below which this much is added to it for barycentric coordinates: colours and
    * texels of such a triangle stay between its vertices' but drift towards vertex 0.
    */
  val MinArea = 16
}
