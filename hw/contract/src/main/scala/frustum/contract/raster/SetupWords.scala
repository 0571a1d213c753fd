package frustum.contract.raster

import scala.collection.mutable.ArrayBuffer

/** A word that the programs of the set-up name; [[SetupMemory]] gives it a place.
  *
  * @param index    its number among all words
  * @param kind     where it is stored
  */
final class SetupWord(val name: String, val index: Int, val kind: SetupWord.Kind) {
  override def toString: String = name
}

object SetupWord {
  sealed trait Kind

  /** In the triangle's slot, kept while the triangle is cached. */
  case object Slot extends Kind

  /** In the slot where this plane is needed. */
  final case class OfPlane(plane: Int) extends Kind

  /** Shared by all slots, needed during one set-up or one move to a tile. */
  case object Shared extends Kind

  /** Shared and never written. */
  final case class Constant(value: Int) extends Kind
}

/** The words that the set-up engine's programs name. */
object SetupWords {
  import SetupWord._
  private val named = ArrayBuffer.empty[SetupWord]

  private def add(name: String, kind: Kind): SetupWord = {
    named += new SetupWord(name, named.length, kind)
    named.last
  }
  private def slot(name: String) = add(name, Slot)
  private def shared(name: String) = add(name, Shared)
  private def constant(name: String, value: Int) = add(name, Constant(value))
  private def perVertex(name: String) = Seq.tabulate(3)(v => shared(s"$name$v"))

  val Planes = 8

  // The slot. Positions in 1/16 pixel; names with "16" are of values times 2^16, so that a product with a plain integer
  // is a plain integer.
  val X0 = slot("X0")
  val Y0 = slot("Y0")
  val DX1_16 = slot("DX1_16")
  val DY1_16 = slot("DY1_16")
  val DX2_16 = slot("DX2_16")
  val DY2_16 = slot("DY2_16")

  /** Steps of edge 0: A0 = dy1 - dy2, B0 = dx2 - dx1. */
  val A0_16 = slot("A0_16")
  val B0_16 = slot("B0_16")

  /** Twice the area, in 1/256 pixel^2. */
  val Area = slot("Area")

  /** dy2, dx2, dy1, dx1 shifted like the area was to reach 2^29..2^30, modulo 2^32. */
  val N1A = slot("N1A")
  val N1B = slot("N1B")
  val N2A = slot("N2A")
  val N2B = slot("N2B")

  /** 2^30 / normalised area, 30 fractional bits. */
  val Reciprocal = slot("Reciprocal")

  private val planeWords =
    Seq.tabulate(Planes)(p => Seq("value", "delta1", "delta2").map(n => add(s"$n$p", OfPlane(p))))

  /** Value of plane p at vertex 0, and its differences at vertices 1 and 2. */
  def value(p: Int): SetupWord = planeWords(p)(0)
  def delta1(p: Int): SetupWord = planeWords(p)(1)
  def delta2(p: Int): SetupWord = planeWords(p)(2)

  // Shared: used by the set-up alone.
  val DX1 = shared("DX1")
  val DX2 = shared("DX2")

  /** Texture coordinates, 22 fraction bits. */
  val (s, t) = (perVertex("s"), perVertex("t"))

  /** Added to s and t of a vertex where the exponents of the triangle's 1/w are the same and its mantissa is 32768, as
    * it is without perspective: a little more than rounding may take from a coordinate in a tile of 16 x 16, so that
    * what is exactly a texel's border belongs to the upper texel. Half a unit of the first value, 30 steps of half a
    * unit, and what the barycentric coordinates' rounding adds where the coordinate differs by 8 repeats at most. It
    * stands in the bits below a vertex's coordinate.
    */
  val TexelBias = 18
  val TexelBiasBits = 6

  /** Twice the mantissa of 1/w, then 1/w itself with 31 fractional bits. */
  val q = perVertex("q")

  /** 2^(30 - (largest exponent - exponent)). */
  val scale = perVertex("scale")

  /** The area shifted to 2^29..2^30, or by [[MaxShift]], with bit 29 set; plus one, so that its reciprocal stays below
    * 2.
    */
  val AreaNormal = shared("AreaNormal")
  val MaxShift = 25

  /** 2^shift and 2^(shift + 4) (14 less for a sliver), shift being that of the area. */
  val Shift = shared("Shift")
  val Shift4 = shared("Shift4")

  /** Of the reciprocal. */
  val Error = shared("Error")

  /** dy2, dx2, dy1, dx1 as [[Shift4]] moves them. */
  val Steps = Seq.tabulate(4)(n => shared(s"step$n"))

  /** Gradients of the lambdas. */
  val L1X = shared("L1X")
  val L1Y = shared("L1Y")
  val L2X = shared("L2X")
  val L2Y = shared("L2Y")

  // Shared: used by the move to a tile, positions relative to vertex 0.

  /** The tile's left and right columns and its top and bottom rows, 1/16 pixel. */
  val Left = shared("Left")
  val Right = shared("Right")
  val Top = shared("Top")
  val Bottom = shared("Bottom")

  /** The codes of the second ones are those of the first ones with the last bit set: hardware reads the one or the
    * other.
    */
  val pairs: Seq[(SetupWord, SetupWord)] = Seq(Left -> Right, Top -> Bottom)

  /** First pixel, times 2^16. */
  val PixelX_16 = shared("PixelX_16")
  val PixelY_16 = shared("PixelY_16")

  /** Of vertices 1 and 2 at the first pixel, before and after the division by the area. */
  val Normal1 = shared("Normal1")
  val Normal2 = shared("Normal2")
  val Lambda1 = shared("Lambda1")
  val Lambda2 = shared("Lambda2")

  // Shared: constants.
  val Nothing = constant("Nothing", 0)

  /** 1 with 30 fractional bits. */
  val One = constant("One", 1 << 30)

  /** 1 with 16 fractional bits: adds a plain integer to the accumulator. */
  val One16 = constant("One16", 1 << 16)

  /** 32/17 and 3/2 with 30 fractional bits: the first guess of 1/d is 48/17 - 32/17 d (d in 1/2..1). */
  val Guess = constant("Guess", scala.math.round(32.0 / 17 * (1 << 30)).toInt)
  val ThreeHalves = constant("ThreeHalves", 3 << 29)

  val all: Seq[SetupWord] = named.toSeq

  // Planes, in the order of the interpolator.
  val PlaneS = 0; val PlaneT = 1; val PlaneQ = 2; val PlaneZ = 3; val PlaneR = 4; val PlaneG = 5; val PlaneB = 6
  val PlaneA = 7
  val AllPlanes: Seq[Int] = 0 until Planes
}
