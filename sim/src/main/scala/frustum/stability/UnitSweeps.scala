package frustum.stability

import frustum.contract.arithmetic.FunctionTable
import frustum.contract.raster.RasterDomains
import frustum.contract.ray.RayDomains
import frustum.contract.video.{ColorFormat, VideoDomains}
import frustum.contract.voxel.VoxelDomains
import frustum.model.raster.fragment.{Blend, Combine}
import frustum.model.video.OrderedDither
import frustum.model.voxel.wide.LayerComposite
import scala.math.sqrt
import scala.util.Random

/** Units of arithmetic by themselves, against the fraction that their inputs stand for. */
object UnitSweeps {

  private def combine(c: Int): Double =
    (for (bits <- Seq(5, 6); t <- 0 until 1 << bits) yield (Combine.channel(t, c) - t * c / 255.0).abs).max

  private def blend(a: Int): Double =
    (for (source <- 0 to 63; target <- 0 to 63)
      yield (Blend.channel(source, target, a) - (source * a + target * (31 - a)) / 31.0).abs).max

  private def dither(bits: Int): Double = {
    val format = ColorFormat(s"$bits bits", bits, bits, bits)
    (0 to 255).map { value =>
      val shown = for (y <- 0 to 3; x <- 0 to 3)
        yield OrderedDither.channel(value, format.red, x, y) * 255.0 / ((1 << bits) - 1)
      (shown.sum / shown.length - value).abs
    }.max
  }

  /** Of arguments from x on, a tenth more. */
  private def relative(table: FunctionTable, scale: Double, f: Double => Double)(x: Double): Double =
    ((x * 65536).toInt until (x * 1.1 * 65536).toInt.max((x * 65536).toInt + 1)).filter(_ < 65536).map { i =>
      val exact = f((i + 0.5) / 65536)
      (table(i) / scale / exact - 1).abs
    }.maxOption.getOrElse(0)

  private val root = new FunctionTable(true, x => 65536 * sqrt(x))
  private val inverse = new FunctionTable(false, x => 16384 / sqrt(x))

  private def layers(count: Int): Double = {
    val random = new Random(1)
    def channel() = Seq(0, 255, random.nextInt(256))(random.nextInt(3))
    Seq.fill(4000) {
      val stack = Seq.tabulate(count)(n => (channel(), if (n == count - 1) 15 else random.nextInt(16)))
      val drawn = stack.foldLeft(LayerComposite.Empty) { case (sum, (c, a)) =>
        sum.behind(Seq(c, c, c), a)
      }.color & 255
      val (exact, _) = stack.foldLeft((0.0, 1.0)) { case ((sum, clear), (c, a)) =>
        (sum + c * clear * a / 15, clear * (15 - a) / 15)
      }
      (drawn - exact).abs
    }.max
  }

  val all: Seq[Sweep] = Seq(
    Sweep(RasterDomains.VertexColor, 0, 255, 8, whole = true)(c => combine(c.toInt)),
    Sweep(RasterDomains.SourceAlpha, 0, 31, 8, whole = true)(a => blend(a.toInt)),
    Sweep(VideoDomains.DitherBits, 0, 12, 64, whole = true)(n => dither(n.toInt)),
    Sweep(RayDomains.Root, 1.0 / 16384, 1, 1)(relative(root, 65536, sqrt)),
    Sweep(RayDomains.InverseRoot, 1.0 / 16384, 1, 1e9)(relative(inverse, 16384, x => 1 / sqrt(x))),
    Sweep(VoxelDomains.Layers, 1, 64, 64, whole = true)(n => layers(n.toInt))
  )
}
