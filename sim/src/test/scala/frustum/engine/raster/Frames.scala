package frustum.engine.raster

import frustum.contract.raster.{
  Combine,
  DepthFunction,
  FramePass,
  PackedTriangle,
  PackedVertex,
  RasterConfig,
  RenderState,
  TexelFormat,
  TextureRef,
  TextureUpload,
  TileRegion,
  Wrap
}
import frustum.driver.raster.{DrawOptions, Driver, PreparedFrame}
import frustum.model.raster.RasterModel
import frustum.reference.raster.ReferenceRaster
import frustum.scene.Scenes
import org.scalatest.Assertions
import scala.util.Random

/** Frames for engine tests, and what the model makes of them. */
object Frames extends Assertions {
  private val options = DrawOptions(None, cullBack = false, Wrap.Repeat, background = 0x203048)

  /** A scene as it turns. */
  def scene(name: String, config: RasterConfig, frames: Int = 1): Seq[PreparedFrame] = {
    val scene = Scenes.byName(name)
    (0 until frames).map(i => Driver.prepare(scene, scene.camera, options.copy(turnDegrees = 25.0 * i), config, i))
  }

  def texture(random: Random): TextureUpload = TextureUpload(0, IndexedSeq.fill(16 * 32)(random.nextInt(65536)))

  /** Triangles anywhere, of any size, in several states. */
  def random(random: Random, config: RasterConfig, frame: Int, count: Int): FramePass = {
    val texture = TextureRef(0, 4, 5, if (random.nextBoolean()) TexelFormat.Rgb565 else TexelFormat.Rgba4444)
    val states = IndexedSeq(
      RenderState(),
      RenderState(Some(texture), combine = Combine.Replace, alphaRef = 9),
      RenderState(
        Some(texture),
        Wrap.Mirror,
        Wrap.Clamp,
        Combine.Modulate,
        DepthFunction.LessEq,
        depthWrite = false,
        blend = true
      )
    )
    def around(centre: Int, span: Int) =
      (centre + random.between(-span, span)).max(-PackedVertex.MaxXy).min(PackedVertex.MaxXy)
    val vertices = IndexedSeq.tabulate(count) { _ =>
      val span = 1 << random.between(5, 13)
      val (x, y) = (random.nextInt(config.width * 16), random.nextInt(config.height * 16))
      IndexedSeq.fill(3)(PackedVertex(
        around(x, span),
        around(y, span),
        random.nextInt(65536),
        random.between(32768, 65536),
        random.between(12, 18),
        random.between(-500000, 500000),
        random.between(-500000, 500000),
        random.nextInt(256),
        random.nextInt(256),
        random.nextInt(256),
        random.nextInt(256)
      ))
    }.flatten
    val triangles = IndexedSeq.tabulate(count)(i => PackedTriangle(random.nextInt(3), 3 * i, 3 * i + 1, 3 * i + 2))
    FramePass(frame, random.nextInt(65536), TileRegion.whole(config), states, vertices, triangles)
  }

  def model(config: RasterConfig, textures: Seq[TextureUpload], passes: Seq[FramePass]): Array[Int] = {
    val image = new Array[Int](config.width * config.height)
    passes.foreach(new RasterModel(config).draw(_, ReferenceRaster.texelMemory(textures), image, None))
    image
  }

  def model(frame: PreparedFrame): Array[Int] = model(frame.config, frame.textures, frame.passes)

  /** Fails with the first pixel that differs. */
  def assertEqual(config: RasterConfig, got: Array[Int], expected: Array[Int], what: String): Unit = {
    val wrong = expected.indices.filter(i => got(i) != expected(i))
    wrong.headOption.foreach { i =>
      fail(f"$what: ${wrong.length} pixels differ, the first at (${i % config.width}, ${i / config.width}): " +
        f"0x${got(i)}%04x, should be 0x${expected(i)}%04x")
    }
  }
}
