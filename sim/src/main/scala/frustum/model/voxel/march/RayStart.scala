package frustum.model.voxel.march

import frustum.contract.arithmetic.ReciprocalTable
import frustum.contract.voxel.{VoxelCamera, VoxelConfig}

/** Where a ray starts and how it runs, in space mirrored so that it goes up along all axes, for a ray that does along
  * axis k coordinate = size - coordinate.
  *
  * The ray is thought to come from the last border of blocks behind the eye along `fast`, the axis of its greatest
  * component: `plane` is that border, `at` the positions there along the two other axes (`fast` + 1 and + 2 modulo 3),
  * [[VoxelConfig.fractionBits]] fraction bits, and from a border to the next each moves on by its slope.
  * Positions along axes that come after `fast` are low by one unit while the slope is not 0: so rays through
  * an edge or a corner meet the border of x first, then of y, then of z.
  *
  * @param crossed whether the eye's block lies beyond the one that `at` is in
  * @param slabs how many borders the ray may cross before it is out of view
  */
final case class RayStart(
    mirrored: Seq[Boolean],
    fast: Int,
    slopes: Seq[Int],
    plane: Int,
    at: Seq[Long],
    crossed: Seq[Boolean],
    slabs: Int
) {
  def others: Seq[Int] = RayAxes.others(fast)
  def octant: Int = mirrored.zipWithIndex.map { case (m, k) => if (m) 1 << k else 0 }.sum

  /** Whether the position along the i-th of the other axes is one unit low. */
  def low(i: Int): Boolean = others(i) > fast && slopes(i) != 0
}
