package frustum.contract.raster

/** Lowest bits that attribute planes go without from pixel to pixel, of the formats of
  * `frustum.raster.InterpolatedFragment`. Each bit less saves a bit of an adder, of its register and of what follows.
  *
  * @param coordinate of s/w, t/w (23 fraction bits) and 1/w (31)
  * @param inverse    of 1/w in addition
  * @param depth      of depth (15 fraction bits)
  * @param color      of red, green, blue and alpha (7 fraction bits)
  */
final case class PlaneFormats(coordinate: Int = 0, depth: Int = 0, color: Int = 0, inverse: Int = 0) {
  require(
    coordinate >= 0 && coordinate <= PlaneFormats.MostCoordinate,
    s"coordinates without $coordinate bits: 0..${PlaneFormats.MostCoordinate}"
  )
  require(
    depth >= 0 && depth <= PlaneFormats.MostDepth,
    s"depth without $depth bits: 0..${PlaneFormats.MostDepth}"
  )
  require(
    color >= 0 && color <= PlaneFormats.MostColor,
    s"colours without $color bits: 0..${PlaneFormats.MostColor}"
  )

  require(
    inverse >= 0 && coordinate + inverse <= PlaneFormats.MostInverse,
    s"1/w without $coordinate and $inverse bits: 0..${PlaneFormats.MostInverse} in all"
  )

  /** Bits that plane p goes without. */
  def dropped(p: Int): Int =
    if (p == SetupWords.PlaneQ) coordinate + inverse
    else if (p < SetupWords.PlaneZ) coordinate
    else if (p == SetupWords.PlaneZ) depth
    else color

  /** A coefficient or a value of plane p without them. */
  def cut(p: Int, value: Int): Int = value >> dropped(p) << dropped(p)
}

object PlaneFormats {
  val MostCoordinate = 20
  val MostInverse = 24
  val MostDepth = 24
  val MostColor = 11
}
