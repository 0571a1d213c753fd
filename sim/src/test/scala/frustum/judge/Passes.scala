package frustum.judge

import frustum.contract.raster.{
  Combine,
  FramePass,
  PackedTriangle,
  PackedVertex,
  RasterConfig,
  RenderState,
  TexelFormat,
  TextureRef,
  TextureUpload,
  TileRegion
}
import frustum.driver.raster.PreparedFrame
import frustum.engine.raster.ReferenceRenderer
import scala.util.Random

/** Small passes for the tests of reference and judges. */
object Passes {
  val config: RasterConfig = RasterConfig(width = 64, height = 48)

  /** A checked texture of 16 x 16 at base 0: every texel differs from its neighbours. */
  val texture: TextureRef = TextureRef(0, 4, 4, TexelFormat.Rgb565)
  val upload: TextureUpload = TextureUpload(0, IndexedSeq.tabulate(256)(i => (i * 40503 + 977) & 0xffff))
  val memory: Array[Int] = upload.texels.toArray.padTo(32768, 0)
  val textured: RenderState = RenderState(Some(texture), combine = Combine.Replace)

  /** Position in pixels; 1/w is a power of two so that it is exact. */
  def vertex(
      x: Double,
      y: Double,
      z: Int = 1000,
      w: Double = 1,
      s: Double = 0,
      t: Double = 0,
      rgba: Int = 0xffffffff
  ): PackedVertex = {
    val (mantissa, exponent) = PackedVertex.reciprocalW(w)
    PackedVertex(
      (x * 16).round.toInt,
      (y * 16).round.toInt,
      z,
      mantissa,
      exponent,
      (s * 65536).round.toInt,
      (t * 65536).round.toInt,
      rgba >>> 24,
      rgba >> 16 & 255,
      rgba >> 8 & 255,
      rgba & 255
    )
  }

  /** Triangles as (state, three vertices), drawn in order. */
  def pass(states: Seq[RenderState], triangles: (Int, Seq[PackedVertex])*): FramePass = FramePass(
    0,
    0,
    TileRegion.whole(config),
    states.toIndexedSeq,
    triangles.flatMap(_._2).toIndexedSeq,
    triangles.zipWithIndex.map { case ((state, _), i) =>
      PackedTriangle(state, 3 * i, 3 * i + 1, 3 * i + 2)
    }.toIndexedSeq
  )

  /** A rectangle of two triangles from (x0, y0) to (x1, y1); s and t run from 0 to 1, t upwards. */
  def quad(
      x0: Double,
      y0: Double,
      x1: Double,
      y1: Double,
      state: Int = 0,
      z: Int = 1000,
      rgba: Int = 0xffffffff
  )
      : Seq[(Int, Seq[PackedVertex])] = {
    def v(x: Double, y: Double, s: Double, t: Double) = vertex(x, y, z, 1, s, t, rgba)
    val (a, b, c, d) = (v(x0, y0, 0, 1), v(x1, y0, 1, 1), v(x1, y1, 1, 0), v(x0, y1, 0, 0))
    Seq((state, Seq(a, b, c)), (state, Seq(a, c, d)))
  }

  /** Triangles anywhere about the screen, some of them slivers, all with textures in perspective. */
  def random(seed: Long, count: Int): FramePass = {
    val random = new Random(seed)
    pass(
      Seq(textured),
      Seq.fill(count) {
        val (cx, cy, size) =
          (random.nextDouble() * 64, random.nextDouble() * 48, 1 + random.nextDouble() * 40)
        def v = vertex(
          cx + (random.nextDouble() - 0.5) * size,
          cy + (random.nextDouble() - 0.5) * size,
          random.nextInt(65536),
          0.5 + random.nextDouble() * 8,
          random.nextDouble() * 4,
          random.nextDouble() * 4
        )
        (0, Seq(v, v, v))
      }: _*
    )
  }

  /** What the reference tells of a pass. */
  def log(pass: FramePass): IndexedSeq[LoggedFragment] = {
    val log = new FragmentLog
    new ReferenceRenderer(config).draw(pass, memory, new Array[Int](64 * 48), Some(log))
    log.fragments
  }

  def frame(passes: FramePass*): PreparedFrame =
    PreparedFrame(
      config,
      Seq(upload),
      passes,
      IndexedSeq.empty,
      passes.map(_.triangles.length).sum,
      0,
      passes.map(_.triangles.indices)
    )
}
