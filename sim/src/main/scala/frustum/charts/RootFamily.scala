package frustum.charts

import frustum.contract.arithmetic.FunctionTable
import frustum.synthesis.UnitCosts
import scala.math.{pow, round, sqrt}

/** Square root and reciprocal square root, the heart of a sphere's shade, by tables, over the arguments that the
  * shade's windows bring there: shifts by an even number of bits put a root's in 1/64..1 and a distance's in 1/16..1.
  */
object RootFamily extends ChartFamily {
  val name = "roots"

  private val Places = 1 << 16
  private val Bits = 16

  private final case class Function(
      name: String,
      title: String,
      least: Double,
      of: Double => Double,
      ours: FunctionTable,
      scale: Double
  )
  private val functions = Seq(
    Function("root", "Square root", 1.0 / 64, sqrt, new FunctionTable(true, x => 65536 * sqrt(x)), 65536),
    Function(
      "reciprocal-root",
      "Reciprocal square root",
      1.0 / 16,
      x => 1 / sqrt(x),
      new FunctionTable(false, x => 16384 / sqrt(x)),
      16384
    )
  )

  private def word(v: Double) = round(v * pow(2, Bits)) / pow(2, Bits)

  private def table(f: Double => Double, bits: Int)(x: Double): Double =
    word(f(((x * (1 << bits)).toInt + 0.5) / (1 << bits)))

  private def line(f: Double => Double, bits: Int)(x: Double): Double = {
    val i = (x * (1 << bits)).toInt
    val (a, b) = (word(f((i.toDouble / (1 << bits)).max(1e-9))), word(f((i + 1.0) / (1 << bits))))
    word(a + (b - a) * (x * (1 << bits) - i))
  }

  /** x (3 - a x^2) / 2, from a table. */
  private def newton(bits: Int, reciprocal: Boolean)(a: Double): Double = {
    val x = table(v => 1 / sqrt(v), bits)(a)
    val y = word(x * (3 - a * x * x) / 2)
    if (reciprocal) y else word(a * y)
  }

  /** Greatest relative error over the window. */
  private def error(f: Function, approximation: Double => Double): Double =
    ((f.least * Places).toInt until Places by 5).map { i =>
      val x = (i + 0.5) / Places
      (approximation(x) / f.of(x) - 1).abs
    }.max

  def charts(costs: Option[UnitCosts]): Seq[Chart] = functions.map { f =>
    val points = for {
      bits <- 5 to 11
      size = (1 << bits) * Bits / 1024.0
      (method, approximation, cost) <- Seq(
        ("table", table(f.of, bits) _, size),
        ("table and line", line(f.of, bits) _, 2 * size),
        ("table and Newton step", newton(bits, f.name != "root") _, size)
      )
    } yield ChartPoint(method, s"2^$bits entries", cost, error(f, approximation))
    val ours =
      ChartPoint("FunctionTable", "2^8 entries", 8, error(f, x => f.ours((x * Places).toInt) / f.scale))
    Chart(
      s"roots-${f.name}",
      f.title,
      "table, kbit",
      "greatest relative error",
      points :+ ours,
      Some(ours),
      None,
      1e-7,
      "A line costs one multiplier, a Newton step three products in a row" + (if (f.name == "root")
                                                                                " and one more for the root."
                                                                              else "."),
      logCost = true
    )
  }
}
