package frustum.model.voxel.march

import frustum.contract.voxel.VoxelConfig

/** Axes and coordinates of the space that is mirrored for a ray so that it goes up along all axes. */
object RayAxes {

  /** The two that come after the fast one, modulo 3. */
  def others(fast: Int): Seq[Int] = Seq((fast + 1) % 3, (fast + 2) % 3)

  /** The eye along axis k. */
  def mirroredEye(config: VoxelConfig, mirrored: Seq[Boolean], eye: Seq[Int], k: Int): Int =
    if (mirrored(k)) (config.size.axes(k) << config.eyeBits) - eye(k) else eye(k)

  /** A block's coordinate along axis k, mirrored or back. */
  def block(config: VoxelConfig, mirrored: Seq[Boolean], block: Int, k: Int): Int =
    if (mirrored(k)) config.size.axes(k) - 1 - block else block
}
