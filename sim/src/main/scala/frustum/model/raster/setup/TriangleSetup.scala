package frustum.model.raster.setup

import frustum.contract.raster.{PackedVertex, SetupInstruction, SetupProgram, SetupWord, SetupWords}
import frustum.contract.raster.SetupInstruction._
import frustum.contract.raster.SetupWords._

/** Bit-exact triangle set-up: runs [[SetupProgram]] on one triangle, without the hardware's timing.
  *
  * @param planes that are wanted; the others' values are 0
  */
final class TriangleSetup(planes: Seq[Int] = SetupWords.AllPlanes) {
  private val program = SetupProgram(planes)

  /** The scratch words, each with a place of its own: the hardware's must be as good. */
  private object word {
    private val values = SetupWords.all.map(_.kind).map { case SetupWord.Constant(v) => v; case _ => 0 }.toArray

    def apply(w: SetupWord): Int = values(w.index)
    def update(w: SetupWord, value: Int): Unit = values(w.index) = value
  }

  private var accumulator = 0L
  private var sliver = false
  private var overflow = false

  /** Per plane: change from pixel to pixel, and from row to row. */
  val gradientX = new Array[Int](Planes)
  val gradientY = new Array[Int](Planes)

  /** Per plane: value at the pixel given to [[rebase]]. */
  val initial = new Array[Int](Planes)

  /** Edge functions at the corners given to [[edges]]: where each walk starts, and from 4 on where they are largest. */
  val edge = new Array[Int](7)

  /** Sets a triangle up; false when it faces away or is degenerate, and draws nothing. */
  def setup(v0: PackedVertex, v1: PackedVertex, v2: PackedVertex): Boolean = {
    fetch(v0, v1, v2)
    run(program.area)
    word(Area) > 0 && {
      val shift = scala.math.min(java.lang.Integer.numberOfLeadingZeros(word(Area)) - 2, MaxShift)
      word(AreaNormal) = word(Area) << shift | 1 << 29 | 1
      word(Shift) = 1 << shift
      word(Shift4) = 1 << (shift + 4)
      run(program.attributes)
      sliver = false
      overflow = false
      run(program.steps)
      if (overflow) {
        sliver = true
        word(Shift4) = word(Shift4) >>> 14
        run(program.steps)
      }
      run(program.gradients)
      true
    }
  }

  /** Steps of edge k per 1/16 pixel. */
  def stepX(k: Int): Int = (k match { case 0 => word(A0_16); case 1 => word(DY2_16); case 2 => -word(DY1_16) }) >> 16
  def stepY(k: Int): Int = (k match { case 0 => word(B0_16); case 1 => -word(DX2_16); case 2 => word(DX1_16) }) >> 16

  /** Edge functions on row `top`, each at the column, `left` or `right`, where its walk starts; and where they are
    * largest.
    */
  def edges(left: Int, right: Int, top: Int, bottom: Int): Unit = {
    word(Left) = 16 * left + 8 - word(X0)
    word(Right) = 16 * right + 8 - word(X0)
    word(Top) = 16 * top + 8 - word(Y0)
    word(Bottom) = 16 * bottom + 8 - word(Y0)
    run(program.edges)
  }

  /** Whether the corners given to [[edges]] hold no pixel of the triangle, as one edge function tells. */
  def outside: Boolean = edge.drop(4).exists(_ < 0)

  /** Values of the planes at a pixel. */
  def rebase(x: Int, y: Int): Unit = {
    word(PixelX_16) = (16 * x + 8 - word(X0)) << 16
    word(PixelY_16) = (16 * y + 8 - word(Y0)) << 16
    run(program.rebase)
  }

  private def fetch(v0: PackedVertex, v1: PackedVertex, v2: PackedVertex): Unit = {
    val v = IndexedSeq(v0, v1, v2)
    word(X0) = v0.x
    word(Y0) = v0.y
    word(DX1) = v1.x - v0.x
    word(DX2) = v2.x - v0.x
    word(DX1_16) = (v1.x - v0.x) << 16
    word(DX2_16) = (v2.x - v0.x) << 16
    word(DY1_16) = (v1.y - v0.y) << 16
    word(DY2_16) = (v2.y - v0.y) << 16
    val exponent = v.map(_.qExponent).max
    for (k <- 0 to 2) {
      val flat = v.forall(_.qExponent == exponent) && (v(k).qMantissa & 0x7fff) == 0
      val bias = if (flat) TexelBias else 0
      word(s(k)) = v(k).s << TexelBiasBits | bias
      word(t(k)) = v(k).t << TexelBiasBits | bias
      word(q(k)) = v(k).qMantissa << 1
      word(scale(k)) = 1 << scala.math.max(0, 30 - (exponent - v(k).qExponent))
    }
    def plane(p: Int, shift: Int)(of: PackedVertex => Int): Unit = {
      word(value(p)) = of(v0) << shift
      word(delta1(p)) = (of(v1) - of(v0)) << shift
      word(delta2(p)) = (of(v2) - of(v0)) << shift
    }
    plane(PlaneZ, 15)(_.z)
    plane(PlaneR, 7)(_.r)
    plane(PlaneG, 7)(_.g)
    plane(PlaneB, 7)(_.b)
    plane(PlaneA, 7)(_.a)
  }

  private def run(section: Seq[SetupInstruction]): Unit = section.foreach { i =>
    val b = word(i.b)
    val falls = (b < 0) != i.subtract
    val a =
      if (i.a == Left && falls != i.far) word(Right)
      else if (i.a == Top && i.far && !falls) word(Bottom)
      else word(i.a)
    val start = i.start match {
      case Keep          => accumulator
      case Zero          => 0L
      case Round         => 1L << 13
      case RoundGradient => if (sliver) 0L else 1L << 13
    }
    val product = (a.toLong * b) >> 16
    accumulator = ((if (i.subtract) start - product else start + product) << 16) >> 16
    def integer = accumulator.toInt
    def fraction = (accumulator >> 14).toInt
    def gradient = if (sliver) integer else fraction
    i.result match {
      case Nowhere      =>
      case Integer(w)   => word(w) = integer
      case Fraction(w)  => word(w) = fraction
      case Checked(w)   => word(w) = integer; if (accumulator >> 29 != 0 && accumulator >> 29 != -1) overflow = true
      case GradientX(p) => gradientX(p) = gradient
      case GradientY(p) => gradientY(p) = gradient
      case Initial(p)   => initial(p) = fraction
      case Edge(e)      => edge(e) = integer
    }
  }
}
