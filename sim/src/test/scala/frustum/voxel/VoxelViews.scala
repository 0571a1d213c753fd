package frustum.voxel

import frustum.contract.voxel.{VoxelConfig, WorldSize}
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.scene.VoxelWorld
import scala.util.Random

/** Views and worlds that tests draw. */
object VoxelViews {

  /** From all kinds of places into all kinds of directions. */
  def apply(c: VoxelConfig, random: Random, n: Int): Seq[VoxelView] = Seq.fill(n) {
    val eye = c.size.axes.map { size =>
      val e = random.nextInt(4) match {
        case 0 => random.between(-32.0, size + 32.0) // as far away as an eye may be
        case _ => random.between(-2.0, size + 2.0)
      }
      if (random.nextInt(4) == 0) e.round.toDouble else e // on a border of blocks
    }
    val (yaw, pitch) = random.nextInt(3) match {
      case 0 => (90.0 * random.nextInt(4), 90.0 * (random.nextInt(3) - 1)) // along the axes
      case _ => (random.between(0.0, 360.0), random.between(-90.0, 90.0))
    }
    VoxelView(Vector3(eye(0), eye(1), eye(2)), yaw, pitch, 0.9 * c.height)
  }

  /** Blocks anywhere. */
  def scatter(size: WorldSize, random: Random, density: Double) =
    VoxelWorld.tabulate(size)((_, _, _) => if (random.nextDouble() < density) 1 + random.nextInt(24) else 0)
}
