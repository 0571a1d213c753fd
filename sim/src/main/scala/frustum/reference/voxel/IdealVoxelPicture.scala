package frustum.reference.voxel

import frustum.contract.voxel.{VoxelAssets, VoxelConfig}
import frustum.driver.voxel.VoxelView
import frustum.referee.{Vec, VoxelRays, WorldBlocks}
import frustum.scene.VoxelWorld
import scala.math.floor

/** The picture in float64: ideal directions, distances in a straight line, colours that are nowhere rounded. */
final class IdealVoxelPicture(c: VoxelConfig, assets: VoxelAssets, blocks: VoxelWorld, rays: VoxelRays) {
  private val world = new WorldBlocks(blocks)
  private val eye = Array(rays.eye.x, rays.eye.y, rays.eye.z)
  private val sky = channels(c.sky)

  private def channels(rgb: Int) = Array(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255).map(_.toDouble)

  /** 0xRRGGBB, row by row. */
  def picture(): Array[Int] = Array.tabulate(c.pixels)(i => pixel(i % c.width, i / c.width))

  def pixel(i: Int, j: Int): Int = {
    val ray = rays.direction(i, j)
    val d = Array(ray.x, ray.y, ray.z)
    val step = d.map(x => if (x < 0) -1 else 1)
    val block =
      Array.tabulate(3)(k => if (d(k) < 0) scala.math.ceil(eye(k)).toInt - 1 else floor(eye(k)).toInt)
    val length = ray.length
    val color = Array(0.0, 0.0, 0.0)
    var (clear, previous) = (1.0, world(block(0), block(1), block(2)))
    def crossing(k: Int) =
      if (d(k) == 0) Double.PositiveInfinity else (block(k) + (if (d(k) < 0) 0 else 1) - eye(k)) / d(k)
    var going = true
    while (going) {
      val axis = (1 to 2).foldLeft(0)((best, k) => if (crossing(k) < crossing(best)) k else best)
      val t = crossing(axis)
      block(axis) += step(axis)
      if (t * length > c.distance) going = false
      else {
        val id = world(block(0), block(1), block(2))
        if (id != 0 && !(id == previous && assets.table(id).joins)) {
          val face = 2 * axis + (if (d(axis) < 0) 1 else 0)
          val at = (0 to 2).map(k => ((eye(k) + t * d(k) - block(k)) * 16).toInt.max(0).min(15))
          val (u, v) = ExactMarch.uv(face, at)
          val rgba = assets.textures(assets.table(id).textures(face), u, v)
          val far = (t * length / c.distance)
          val fog = if (c.fog) ((far * far - 9.0 / 16) / (7.0 / 16)).max(0) else 0
          val weight = clear * (rgba & 15) / 15
          for (k <- 0 to 2) {
            val lit = (rgba >> 12 - 4 * k & 15) * 17 * VoxelConfig.Light(face) / 256.0
            color(k) += weight * (lit + (sky(k) - lit) * fog)
          }
          clear -= weight
          going = clear > 0 && !assets.table(id).opaque
        }
        previous = id
      }
    }
    (0 to 2).map(k => (color(k) + clear * sky(k)).round.toInt.max(0).min(255)).foldLeft(0)(_ << 8 | _)
  }
}

object IdealVoxelPicture {
  def apply(c: VoxelConfig, assets: VoxelAssets, world: VoxelWorld, view: VoxelView): IdealVoxelPicture =
    new IdealVoxelPicture(c, assets, world, rays(view, c))

  /** The ideal rays of what the user asked for. */
  def rays(view: VoxelView, c: VoxelConfig): VoxelRays = {
    val eye = Vec(view.eye)
    view.asked.fold(VoxelRays.ofAngles(eye, view.yaw, view.pitch, view.focal, c.width, c.height))(along =>
      VoxelRays.ofDirection(eye, Vec(along), view.focal, c.width, c.height)
    )
  }
}
