package frustum.charts.systems

import frustum.contract.raster.{FramePass, PackedVertex, PlaneFormats, RasterConfig, VertexRanges, Wrap}
import frustum.contract.video.ColorFormat
import frustum.driver.raster.{DrawOptions, PreparedFrame}
import frustum.driver.scene.Scene
import frustum.fit.FitFeatures
import frustum.model.raster.{PassRenderer, RasterModel}
import frustum.raster.texture.LateDivide
import scala.math.rint

/** A whole renderer: hardware, and what its driver makes of a frame.
  *
  * @param group    what it differs in from the shipped one, @param setting by how much
  * @param config   of the hardware
  * @param options  of the driver
  * @param adjust   what becomes of a frame's vertices on their way to the hardware
  * @param renderer the model; another method than the hardware's where `built` is false
  * @param format   colours that the picture has in the end
  * @param built    whether the library has such hardware
  */
final case class SystemConfiguration(
    group: String,
    setting: String,
    config: RasterConfig,
    options: DrawOptions,
    adjust: PackedVertex => PackedVertex = identity,
    renderer: RasterConfig => PassRenderer = new RasterModel(_),
    format: ColorFormat = ColorFormat.Rgb565,
    built: Boolean = true
) {

  /** A pixel of the hardware's picture, 0xRRGGBB, in the colours that it ends in: lower bits are cut. */
  def shown(rgb: Int): Int =
    if (format == ColorFormat.Rgb565) rgb
    else
      format.channels.zip(Seq(16, 8, 0)).map { case (bits, shift) =>
        rint((rgb >> shift + 8 - bits & (1 << bits) - 1) * 255.0 / ((1 << bits) - 1)).toInt << shift
      }.sum

  /** A prepared frame as it goes on the wire. */
  def sent(frame: PreparedFrame): PreparedFrame =
    frame.copy(passes = frame.passes.map((p: FramePass) => p.copy(vertices = p.vertices.map(adjust))))
}

object SystemConfiguration {
  val Shipped = "shipped"
  val Tiles = "tile size"
  val Coordinates = "bits of texture coordinates and 1/w"
  val Depth = "bits of depth"
  val Colors = "bits of interpolated colours"
  val Vertices = "sub-pixel bits of vertices"
  val Picture = "colours of the picture, of 16 bits"
  val Affine = "affine mapping in place of perspective"
  val Scene = "made for this scene (by inspection)"
  val Fitted = "fitted to this scene (`fit`)"

  /** As the scene is drawn without arguments. */
  def plain(scene: Scene): DrawOptions = DrawOptions(None, cullBack = false, Wrap.Repeat, scene.background)

  /** What can be built, or is a method of its own, for a scene. */
  def all(scene: Scene, base: RasterConfig = RasterConfig()): Seq[SystemConfiguration] = {
    val options = plain(scene)
    val textured = scene.materials.exists(_.texture.isDefined)
    def formats(group: String, setting: String, f: PlaneFormats) =
      SystemConfiguration(group, setting, base.copy(formats = f), options)
    val shipped = SystemConfiguration(Shipped, s"${base.tileWidth} x ${base.tileHeight} tiles, all bits", base, options)
    val tiles = for ((w, h) <- Seq((5, 4), (5, 5)))
      yield SystemConfiguration(
        Tiles,
        s"${1 << w} x ${1 << h}",
        base.copy(tileLog2Width = w, tileLog2Height = h),
        options
      )
    val coordinates = Seq(4, 8, 12).map(n => formats(Coordinates, s"${32 - n} of 32", PlaneFormats(coordinate = n)))
    val depth = Seq(19, 23).map(n => formats(Depth, s"${31 - n} of 31", PlaneFormats(depth = n)))
    val colors = Seq(10, 11).map(n => formats(Colors, s"${15 - n} of 15", PlaneFormats(color = n)))
    val snapped = Seq(2, 0).map(n => shipped.copy(group = Vertices, setting = s"$n of 4", adjust = snap(n)))
    val spans = Seq(8, 16).map(n =>
      shipped.copy(
        group = Affine,
        setting = s"spans of $n pixels",
        renderer = new AffineSpans(_, n),
        built = false
      )
    )
    val pictures = Seq(ColorFormat.Rgb444, ColorFormat.Rgb332)
      .map(f => shipped.copy(group = Picture, setting = s"${f.bits} bits", format = f, built = false))
    val triangles = shipped.copy(group = Affine, setting = "whole triangles", adjust = flat)
    (shipped +: tiles) ++ (if (textured) coordinates else Nil) ++ depth ++ (if (textured) Nil
                                                                            else colors) ++ snapped ++ pictures ++
      (if (textured) spans :+ triangles else Nil) ++ made(scene, base, options)
  }

  /** Hardware that can do what the scene asks for and no more; with the divide that suits depths near each other, and
    * without.
    */
  private def made(scene: Scene, base: RasterConfig, options: DrawOptions): Seq[SystemConfiguration] = {
    val features = FitFeatures(scene, base, options)
    val own = SystemConfiguration(Scene, "as inspected", features.config, features.options)
    if (!LateDivide.suits(features.config)) Seq(own)
    else {
      val early = features.config.copy(ranges = features.config.ranges.copy(ratio = VertexRanges().ratio))
      Seq(own.copy(setting = "divide late"), own.copy(setting = "divide early", config = early))
    }
  }

  /** To the nearest of 2^bits places of a pixel that is within the range of positions. */
  private def snap(bits: Int)(v: PackedVertex): PackedVertex = {
    val step = 1 << 4 - bits
    val most = PackedVertex.MaxXy / step * step
    def near(p: Int) = (Math.floorDiv(p + step / 2, step) * step).max(-most).min(most)
    v.copy(x = near(v.x), y = near(v.y))
  }

  /** As if all lay in one depth: coordinates are linear on the screen. */
  private def flat(v: PackedVertex): PackedVertex = {
    val (mantissa, exponent) = PackedVertex.reciprocalW(1)
    v.copy(qMantissa = mantissa, qExponent = exponent)
  }
}
