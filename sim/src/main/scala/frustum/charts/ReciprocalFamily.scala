package frustum.charts

import frustum.contract.arithmetic.ReciprocalTable
import frustum.contract.raster.{RasterConfig, VertexRanges}
import frustum.device.Tech
import frustum.{model, raster}
import frustum.synthesis.UnitCosts
import scala.math.{floor, log, round}
import scala.util.Random

/** Reciprocals of a mantissa in [1, 2): the heart of the perspective divide and of the voxel world's slopes.
  *
  * Words of tables have as many bits as their error asks for, and two more. Errors are the greatest over 2^20
  * mantissas.
  */
object ReciprocalFamily extends ChartFamily {
  val name = "perspective"

  private val Fractions = 1 << 20
  private def word(value: Double, bits: Int) = round(value * (1L << bits)) / (1L << bits).toDouble

  /** Greatest |approximation (1 + f) - 1|. */
  private def error(approximation: Double => Double): Double =
    (0 until Fractions by 7).map { i =>
      val f = (i + 0.5) / Fractions
      (approximation(f) * (1 + f) - 1).abs
    }.max

  private def table(bits: Int): (Int, Double => Double) = {
    val size = 1 << bits
    val wide = bits + 3
    val words = Array.tabulate(size)(i => word(1 / (1 + (i + 0.5) / size), wide))
    (size * wide, f => words((f * size).toInt))
  }

  private def linear(bits: Int): (Int, Double => Double) = {
    val size = 1 << bits
    val wide = 2 * bits + 5
    val bases = Array.tabulate(size) { i =>
      val (a, b, m) = (1 / (1 + i.toDouble / size), 1 / (1 + (i + 1.0) / size), 1 / (1 + (i + 0.5) / size))
      word(a + (m - (a + b) / 2) / 2, wide) // half of the line's own error
    }
    val slopes = Array.tabulate(size)(i =>
      word(size * (1 / (1 + (i + 1.0) / size) - 1 / (1 + i.toDouble / size)), bits + 5)
    )
    (
      size * (wide + bits + 5),
      f => { val i = (f * size).toInt; word(bases(i) + slopes(i) * (f - i.toDouble / size), wide) }
    )
  }

  /** r (2 - d r): the error squares. */
  private def newton(bits: Int): (Int, Double => Double) = {
    val (memory, first) = table(bits)
    (memory, f => { val r = first(f); word(r * (2 - (1 + f) * r), 2 * bits + 5) })
  }

  /** How many correct bits an approximation has. */
  def bitsOf(error: Double): Double = -log(error) / log(2)

  /** Greatest error in texels of 128, of coordinates within a repeat of 0, where q is down to 2^-`ratio` of its
    * greatest.
    */
  def texelError(ratio: Int = 14)(quotient: (Int, Int) => Double): Double = {
    val random = new Random(1)
    Seq.fill(100000) {
      val q = (1 << 30 | random.nextInt(1 << 30)) >> random.nextInt(ratio + 1)
      val s = ((random.nextDouble() * 2 - 1) * q / 256).toInt
      (quotient(s, q) - s.toDouble * 256 / q).abs * 128
    }.max
  }

  /** What divides, and how large and fast it is. */
  private def dividers(costs: UnitCosts): Chart = {
    val long = for (fraction <- Seq(8, 12, 17)) yield {
      val unit = costs.timed(s"long division to $fraction bits")(new LongDivision(fraction))
      val error = texelError()((s, q) => LongDivision(s, q, fraction) / (1L << fraction).toDouble)
      ChartPoint("long division, a row a bit", s"$fraction fraction bits", unit.cells, error, Some(unit))
    }
    val unit = costs.timed("perspective divide")(raster.texture.PerspectiveDivide(Tech.Ice40))
    val ours = ChartPoint(
      "table, line and multipliers",
      "PerspectiveDivide",
      unit.cells,
      texelError()((s, q) => model.raster.texture.PerspectiveDivide(s, q) / 131072.0),
      Some(unit)
    )
    val late = for (ratio <- 1 to VertexRanges.LateRatio) yield {
      val config = RasterConfig(ranges = VertexRanges(ratio = ratio))
      val divide = new model.raster.texture.LateDivide(config)
      val unit = costs.timed(s"late divide, w ratios to ${1 << ratio}")(raster.texture.LateDivide(config, Tech.Ice40))
      val error = texelError(ratio)((s, q) => divide(s, q) / 131072.0)
      ChartPoint("shifted after the table: LateDivide", s"w ratios to ${1 << ratio}", unit.cells, error, Some(unit))
    }
    Chart(
      "perspective-dividers",
      "Two coordinates divided a clock",
      "LUT and flip-flops, iCE40",
      "greatest error, texels of 128",
      (long :+ ours) ++ late,
      Some(ours),
      None,
      1e-6,
      s"Ours has ${unit.multipliers} of the UP5K's 8 multipliers and ${unit.blockRams} of its 30 block RAMs as well; " +
        "long division has none. LateDivide is for fitted hardware: less logic, more block RAM. Without MHz: it does " +
        "not fit the UP5K.",
      logCost = true
    )
  }

  def charts(costs: Option[UnitCosts]): Seq[Chart] = reciprocals +: costs.map(dividers).toSeq

  private def reciprocals: Chart = {
    val points = for {
      (method, make) <-
        Seq("table" -> table _, "table and line" -> linear _, "table and Newton step" -> newton _)
      bits <- 3 to 11
    } yield {
      val (memory, approximation) = make(bits)
      ChartPoint(method, s"2^$bits entries", memory / 1024.0, error(approximation))
    }
    val ours = ChartPoint(
      "ReciprocalTable",
      s"2^${ReciprocalTable.IndexBits} entries",
      (1 << ReciprocalTable.IndexBits) * (ReciprocalTable.BaseBits + ReciprocalTable.SlopeBits) / 1024.0,
      error(f => 1 - ReciprocalTable(floor(f * (1 << 20)).toInt) / 131072.0)
    )
    Chart(
      "perspective-reciprocal",
      "Reciprocal of 1/w",
      "table, kbit",
      "greatest relative error",
      points :+ ours,
      Some(ours),
      None,
      1e-9,
      "A line costs one multiplier, a Newton step two in a row and so two multipliers' latency. A relative error e " +
        "moves a texel coordinate of n texels by n e.",
      logCost = true
    )
  }
}
