package frustum.judge

import frustum.contract.voxel.{LeapField, VoxelCamera, VoxelConfig}
import frustum.driver.voxel.VoxelView
import frustum.model.voxel.march.{Marcher, RayStart}
import frustum.model.voxel.{VoxelModel, VoxelPixel}
import frustum.model.voxel.world.LeapWords
import frustum.referee.{Vec, VoxelRays, WorldBlocks}
import frustum.reference.voxel.{ExactMarch, IdealVoxelPicture}

/** What was found over all rays of a picture, or of several.
  *
  * @param steps words of memory read; `plainSteps` by the same rays going a block at a time
  * @param blocksWrong rays that see other blocks than exact marching with the same direction does
  * @param facesWrong rays that see the right blocks, one of them on another face
  * @param texelsWrong rays that see the right faces, one of them at another texel
  */
final case class VoxelCounts(
    rays: Long = 0,
    steps: Long = 0,
    plainSteps: Long = 0,
    blocksWrong: Long = 0,
    facesWrong: Long = 0,
    texelsWrong: Long = 0,
    maxDirectionErrorPixels: Double = 0
) {
  def +(o: VoxelCounts): VoxelCounts = VoxelCounts(
    rays + o.rays,
    steps + o.steps,
    plainSteps + o.plainSteps,
    blocksWrong + o.blocksWrong,
    facesWrong + o.facesWrong,
    texelsWrong + o.texelsWrong,
    maxDirectionErrorPixels.max(o.maxDirectionErrorPixels)
  )

  def failures: Seq[String] = Seq(
    "wrong block" -> blocksWrong,
    "wrong face" -> facesWrong,
    "wrong texel" -> texelsWrong
  ).collect { case (what, n) if n > 0 => s"$n rays see a $what" }
}

/** Holds the model's rays against exact marching with the same directions, and their directions against the ideal ones.
  */
final class VoxelJudge(model: VoxelModel) {
  import model.{assets, config, world}
  private val blocks = new WorldBlocks(world)
  private val plain =
    new Marcher(config.copy(leaps = LeapField.Plain), assets.table, LeapWords(world, LeapField.Plain))

  def ray(camera: VoxelCamera, pixel: VoxelPixel): VoxelCounts = {
    val direction = VoxelJudge.direction(pixel.ray, config.slopeBits)
    val exact =
      new ExactMarch(config, assets.table, blocks, camera.eye.axes, direction, pixel.ray.mirrored).march()
    def differs(same: (Int, Int) => Boolean) =
      exact.length != pixel.seen.length || !exact.indices.forall(i => same(i, i))
    val block = differs((i, k) => exact(i).sameBlock(pixel.seen(k)))
    val face = !block && differs((i, k) => exact(i).sameFace(pixel.seen(k)))
    val texel = !block && !face && differs((i, k) => exact(i) == pixel.seen(k))
    def one(b: Boolean) = if (b) 1L else 0L
    VoxelCounts(1, pixel.steps, plain.march(pixel.ray)(_ => ()), one(block), one(face), one(texel))
  }

  /** All of a picture, the directions' errors with it. */
  def picture(camera: VoxelCamera, view: VoxelView, pixels: IndexedSeq[VoxelPixel]): VoxelCounts = {
    val ideal = IdealVoxelPicture.rays(view, config)
    pixels.indices.foldLeft(VoxelCounts()) { (sum, n) =>
      val error = VoxelJudge.error(ideal, n % config.width, n / config.width, pixels(n).ray, config)
      sum + ray(camera, pixels(n)).copy(maxDirectionErrorPixels = error)
    }
  }
}

object VoxelJudge {

  /** How far the ray of pixel (i, j) lies from the ideal one, in pixels. */
  def error(ideal: VoxelRays, i: Int, j: Int, ray: RayStart, c: VoxelConfig): Double = {
    val Seq(x, y, z) = direction(ray, c.slopeBits).map(_.toDouble)
    ideal.error(i, j, Vec(x, y, z))
  }

  /** The direction that a ray really has. */
  def direction(ray: RayStart, slopeBits: Int): Seq[Long] = {
    val along = Map(ray.fast -> (1L << slopeBits)) ++ ray.others.zip(ray.slopes.map(_.toLong))
    (0 to 2).map(k => if (ray.mirrored(k)) -along(k) else along(k))
  }
}
