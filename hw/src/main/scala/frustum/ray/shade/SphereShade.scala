package frustum.ray.shade

import frustum.arithmetic.{FunctionUnit, MemoryDelay, Multiplier16, WideMultiplier}
import frustum.contract.ray.{RayShade, ShadeWindow}
import frustum.device.Tech
import spinal.core._
import spinal.lib._

/** How far a sphere's pixel is lit, 0 where the light does not reach, one pixel per cycle. Formulas and formats:
  * [[frustum.contract.ray.RayShade]].
  *
  * What enters belongs to one pixel at different cycles, so that it need not be kept: `q` first, `towards` after
  * `towardsAge` cycles and so on; `level` comes out after `latency`.
  */
case class SphereShade(format: RayShade, tech: Tech = Tech.Generic) extends Component {
  import format._
  val towardsAge: Int = 1 + FunctionUnit.Latency
  val litAge: Int = towardsAge + Multiplier16.Latency
  val squareAge: Int = litAge + 1 - FunctionUnit.Latency
  private val numberAge = litAge + 1 + Multiplier16.Latency
  val powerAge: Int = numberAge
  val latency: Int = powerAge + 2 + FunctionUnit.Latency + Multiplier16.Latency

  val io = new Bundle {
    val q = in UInt (rootBits bits)
    val towards = in SInt (towardsBits bits)
    val lit = in SInt (litBits bits)
    val square = in UInt (squareBits bits)
    val power = in SInt (powerBits + 1 bits)
    val level = out UInt (RayShade.LevelBits bits)
  }
  private def right(v: SInt, by: Int): SInt = if (by >= 0) v >> by else v << -by

  /** The upper bits of v, `bits` long. */
  private def top(v: UInt, bits: Int): UInt =
    if (v.getWidth >= bits) v >> (v.getWidth - bits) else v << (bits - v.getWidth)

  /** How many of the upper groups of `w.step` bits are zero, at most `w.last`. */
  private def zeros(v: UInt, w: ShadeWindow): UInt = {
    val n = UInt(log2Up(w.last + 1) bits)
    n := w.last
    for (k <- w.last - 1 to 0 by -1)
      when(v(v.high - w.step * k downto v.high - w.step * (k + 1) + 1) =/= 0)(n := k)
    n
  }

  /** 16 bits of v after a shift to the left by n steps. */
  private def window(v: UInt, n: UInt, w: ShadeWindow): UInt =
    Vec((0 to w.last).map(k => top(v |<< (w.step * k), 16))).read(n)

  val root = new Area {
    val n = zeros(io.q, RayShade.RootWindow)
    val table = FunctionUnit(format.root, tech)
    table.io.x := RegNext(window(io.q, n, RayShade.RootWindow))
    private val late = Delay(n, towardsAge)
    val value = Vec((0 to RayShade.RootWindow.last).map(k =>
      table.io.y |>> (RayShade.RootWindow.step / 2 * k)
    )).read(late)
  }
  val reciprocal = FunctionUnit(format.reciprocal, tech)
  reciprocal.io.x := top(io.square, 16)

  val number = new Area {
    val product = WideMultiplier(tech, towardsBits)
    product.io.a := io.towards
    product.io.b := root.value
    val numerator = RegNext(
      (io.lit >> numeratorShift).resize(numeratorBits) - right(
        product.io.product,
        productShift
      ).resize(numeratorBits)
    )
    val quotient = WideMultiplier(tech, numeratorBits)
    quotient.io.a := numerator
    quotient.io.b := reciprocal.io.y
    val value = (quotient.io.product >> numberShift).resize(numberBits)
  }
  val distance = new Area {
    val square = RegNext((io.power << fraction) - (number.value << 1))
    val m = RegNext(number.value)
    val lit = m > 0 && square > 0 && RegNext(io.power > 0)
    val d = square.asUInt.resize(distanceBits)
    val n = zeros(d, RayShade.DistanceWindow)
    val table = FunctionUnit(format.distance, tech)
    table.io.x := RegNext(window(d, n, RayShade.DistanceWindow))
    val scaled = Vec(
      (0 to RayShade.DistanceWindow.last).map(k =>
        right(m, scaleShift - RayShade.DistanceWindow.step / 2 * k).resize(16).asBits
      )
    ).read(n)
    val light = Delay(lit, 1 + FunctionUnit.Latency + Multiplier16.Latency)
  }
  val scale = Multiplier16(tech, signedA = false, signedB = false)
  scale.io.enable := True
  scale.io.a := MemoryDelay(distance.scaled, 1 + FunctionUnit.Latency)
  scale.io.b := distance.table.io.y.asBits
  private val product = scale.io.product.asUInt
  io.level := Mux(
    !distance.light,
    U(0),
    product(RayShade.LevelShift, RayShade.LevelBits bits) |
      U(RayShade.LevelBits bits, default -> (product >> (RayShade.LevelShift + RayShade.LevelBits)).orR)
  )
}
