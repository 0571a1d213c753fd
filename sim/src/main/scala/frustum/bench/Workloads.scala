package frustum.bench

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
  TileRegion
}
import scala.util.Random

/** The triangles behind the figures of `bench raster`: 64 x 64 texture, depth test less, source-alpha blend, at random
  * places of the screen in steps of 1/16 pixel.
  */
final class Workloads(config: RasterConfig, seed: Long) {
  import Workloads._
  private val random = new Random(seed)
  private val (width, height) = (config.width * 16, config.height * 16)

  val texture: TextureUpload = TextureUpload(0, IndexedSeq.fill(64 * 64)(random.nextInt(65536)))
  val state: RenderState = RenderState(
    Some(TextureRef(0, 6, 6, TexelFormat.Rgb565)),
    combine = Combine.Modulate,
    depth = DepthFunction.Less,
    blend = true
  )

  def rightTriangle(n: Int): Corners = placed(Seq((0, 0), (16 * n, 0), (0, 16 * n)))
  def diagonalSliver: Corners = placed(Seq((0, 0), (60 * 16, 58 * 16), (60 * 16, 59 * 16)))
  def randomIn16: Corners = placed(Seq.fill(3)((random.nextInt(257), random.nextInt(257))))

  /** Two vertices at most 3 pixels apart, the third anywhere. */
  def needle: Corners = {
    val (x, y) = (random.nextInt(width), random.nextInt(height))
    val (dx, dy) = Iterator.continually((random.between(-48, 49), random.between(-48, 49))).find { case (a, b) =>
      a * a + b * b <= 48 * 48
    }.get
    Seq((x, y), (x + dx, y + dy), (random.nextInt(width), random.nextInt(height)))
  }

  /** Two triangles over the whole screen, w = 1, texture coordinates 0..1. */
  def fullScreen: FramePass = {
    val corners = Seq((0, 0), (width, 0), (width, height), (0, height))
    pass(
      corners.map { case (x, y) => vertex(x, y, x / (width / 65536.0), 65536 - y / (height / 65536.0)) },
      Seq((0, 1, 2), (0, 2, 3)),
      TileRegion.whole(config)
    )
  }

  def empty(region: TileRegion): FramePass = pass(Nil, Nil, region)

  /** A frame with `copies` of a triangle, of no more of the screen than the tiles that the triangle's box touches. */
  def frame(corners: Corners, copies: Int): FramePass = {
    def tiles(at: Seq[Int], log2: Int, count: Int) =
      ((at.min >> (4 + log2)).max(0).min(count - 1), (at.max >> (4 + log2)).max(0).min(count - 1))
    val (x0, x1) = tiles(corners.map(_._1), config.tileLog2Width, config.tilesX)
    val (y0, y1) = tiles(corners.map(_._2), config.tileLog2Height, config.tilesY)
    val area = {
      val Seq((ax, ay), (bx, by), (cx, cy)) = corners; (bx - ax).toLong * (cy - ay) - (by - ay).toLong * (cx - ax)
    }
    val turned = if (area > 0) corners else Seq(corners(0), corners(2), corners(1))
    val vertices = turned.map { case (x, y) => vertex(x, y, (x - turned.head._1) * 64.0, (y - turned.head._2) * 64.0) }
    pass(vertices, Seq.fill(copies)((0, 1, 2)), TileRegion(x0, y0, x1, y1))
  }

  /** Somewhere on the screen, the whole of it. */
  private def placed(corners: Corners): Corners = {
    val (right, bottom) = (corners.map(_._1).max, corners.map(_._2).max)
    val (x, y) = (random.nextInt((width - right).max(1)), random.nextInt((height - bottom).max(1)))
    corners.map { case (a, b) => (a + x, b + y) }
  }

  private def vertex(x: Int, y: Int, s: Double, t: Double) = {
    val (mantissa, exponent) = PackedVertex.reciprocalW(1)
    PackedVertex(x, y, random.nextInt(65536), mantissa, exponent, s.toInt, t.toInt, 200, 220, 240, 128)
  }

  private def pass(vertices: Seq[PackedVertex], triangles: Seq[(Int, Int, Int)], region: TileRegion) = FramePass(
    nextFrame(),
    0,
    region,
    IndexedSeq(state),
    vertices.toIndexedSeq,
    triangles.map { case (a, b, c) => PackedTriangle(0, a, b, c) }.toIndexedSeq
  )
  private var frames = 0
  private def nextFrame() = { frames += 1; frames & 0xffff }
}

object Workloads {

  /** Three points, 1/16 pixel. */
  type Corners = Seq[(Int, Int)]
}
