package frustum.contract.raster

/** The words that the set-up engine's programs name: first those of a triangle's slot, then those that all slots share.
  * In the scratch memory the shared ones come first, then slot after slot.
  */
object SetupWords {
  val SlotWords = 38
  val SharedWords = 26

  /** First shared word. */
  val Shared = SlotWords

  /** Hardware's name of a word, [[CodeBits]] wide: a flag for shared ones, then the place in the slot or among them. A slot holds the words
    * of wanted planes alone.
    */
  def code(word: Int, planes: Seq[Int]): Int =
    if (word >= Shared) 1 << (CodeBits - 1) | word - Shared
    else if (word < value(0)) word
    else {
      val at = planes.indexOf((word - value(0)) / 3)
      require(at >= 0, s"word $word is of a plane that is not among $planes")
      value(at) + (word - value(0)) % 3
    }

  /** Words of a slot with these planes. */
  def slotWords(planes: Seq[Int]): Int = value(planes.length)
  val CodeBits = 7
  val Planes = 8

  // The slot, kept while the triangle is cached. Positions in 1/16 pixel;
  // "16" marks values held times 2^16, so that a product with a plain integer is a plain integer.
  val X0 = 0; val Y0 = 1
  val DX1_16 = 2; val DY1_16 = 3; val DX2_16 = 4; val DY2_16 = 5

  /** Steps of edge 0: A0 = dy1 - dy2, B0 = dx2 - dx1. */
  val A0_16 = 6; val B0_16 = 7

  /** Twice the area, in 1/256 pixel^2. */
  val Area = 8

  /** dy2, dx2, dy1, dx1 shifted like the area was to reach 2^29..2^30, modulo 2^32. */
  val N1A = 9; val N1B = 10; val N2A = 11; val N2B = 12

  /** 2^30 / normalised area, 30 fractional bits. */
  val Reciprocal = 13

  /** Value of plane p at vertex 0, and its differences at vertices 1 and 2. */
  def value(p: Int): Int = 14 + 3 * p
  def delta1(p: Int): Int = 15 + 3 * p
  def delta2(p: Int): Int = 16 + 3 * p

  // Shared: used by the set-up alone.
  val DX1 = 56; val DX2 = 57
  def s(v: Int): Int = 40 + v
  def t(v: Int): Int = 43 + v

  /** Twice the mantissa of 1/w, then 1/w itself with 31 fractional bits. */
  def q(v: Int): Int = 46 + v

  /** 2^(30 - (largest exponent - exponent)). */
  def scale(v: Int): Int = 49 + v

  /** The area shifted to 2^29..2^30, or by [[MaxShift]], with bit 29 set; plus one, so that its reciprocal stays below 2. */
  val MaxShift = 25
  val AreaNormal = 52

  /** 2^shift and 2^(shift + 4) (14 less for a sliver), shift being that of the area. */
  val Shift = 53; val Shift4 = 54
  val Error = 55
  val L1X = 40; val L1Y = 41; val L2X = 42; val L2Y = 49
  val Temporary = Seq(44, 45, 46, 47)

  // Shared: used by the move to a tile, positions relative to vertex 0.
  /** The tile's left and right columns and its top and bottom rows, 1/16 pixel. The codes of `Right` and `Bottom` are those
    * of `Left` and `Top` with the last bit set.
    */
  val Left = 56; val Right = 57; val Top = 58; val Bottom = 59

  /** First pixel, times 2^16. */
  val PixelX_16 = 56; val PixelY_16 = 57
  val Lambda1 = 58; val Lambda2 = 59
  val Normal1 = 54; val Normal2 = 55

  // Shared: constants.
  val Nothing = 39

  /** 1 with 30 fractional bits. */
  val One = 60

  /** 1 with 16 fractional bits: adds a plain integer to the accumulator. */
  val One16 = 61

  /** 32/17 and 3/2 with 30 fractional bits: the first guess of 1/d is 48/17 - 32/17 d (d in 1/2..1). */
  val Guess = 62; val ThreeHalves = 63
  val constants: Map[Int, Int] = Map(
    One -> (1 << 30),
    One16 -> (1 << 16),
    Guess -> scala.math.round(32.0 / 17 * (1 << 30)).toInt,
    ThreeHalves -> (3 << 29)
  )

  // Planes, in the order of the interpolator.
  val PlaneS = 0; val PlaneT = 1; val PlaneQ = 2; val PlaneZ = 3; val PlaneR = 4; val PlaneG = 5; val PlaneB = 6
  val PlaneA = 7
  val AllPlanes: Seq[Int] = 0 until Planes
}
