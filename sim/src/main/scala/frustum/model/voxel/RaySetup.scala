package frustum.model.voxel

import frustum.spec.{ReciprocalTable, VoxelCamera, VoxelConfig}

/** Where a ray starts and how it runs, in space mirrored so that it goes up along all axes, for a ray that does along axis k
  * coordinate = size - coordinate.
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
  def others: Seq[Int] = Seq((fast + 1) % 3, (fast + 2) % 3)
  def octant: Int      = mirrored.zipWithIndex.map { case (m, k) => if (m) 1 << k else 0 }.sum

  /** Whether the position along the i-th of the other axes is one unit low. */
  def low(i: Int): Boolean = others(i) > fast && slopes(i) != 0
}

object RaySetup {
  private val Bits = VoxelCamera.DirectionBits

  /** |minor / major| with 15 fraction bits by the reciprocal of the major's mantissa, 1 / (1 + f) = 1 - r / 2. */
  private def slope(minor: Int, major: Int, c: VoxelConfig): Int = {
    val half     = major >> Bits == 0 // below 1, at least 1/2
    val fraction = (if (half) major >> 1 else major >> 2) & (1 << 20) - 1
    val v        = if (half) minor >> 6 else minor >> 7
    val quotient = v - (v.toLong * ReciprocalTable(fraction) >> 17).toInt
    quotient.min((1 << 15) - 1) >> 15 - c.slopeBits
  }

  def apply(eye: Seq[Int], direction: Seq[Int], c: VoxelConfig): RayStart = {
    val mirrored  = direction.map(_ < 0)
    val magnitude = direction.map(_.abs)
    require(
      magnitude.max >> Bits - 1 != 0 && magnitude.max >> Bits + 1 == 0,
      s"direction $direction is out of range"
    )
    val fast   = magnitude.indexOf(magnitude.max)
    val others = Seq((fast + 1) % 3, (fast + 2) % 3)
    val slopes = others.map(k => slope(magnitude(k), magnitude(fast), c))
    val p      = (0 to 2).map(k => if (mirrored(k)) (c.size.axes(k) << c.eyeBits) - eye(k) else eye(k))
    val behind = p(fast) & (1 << c.eyeBits) - 1
    val at     = others.zip(slopes).map { case (k, s) =>
      (p(k).toLong << c.slopeBits) - s.toLong * behind - (if (k > fast && s != 0) 1 else 0)
    }
    RayStart(
      mirrored,
      fast,
      slopes,
      p(fast) >> c.eyeBits,
      at,
      others.zip(at).map { case (k, a) => (a >> c.fractionBits) < (p(k) >> c.eyeBits) },
      c.slabs(slopes(1) >> c.slopeBits - 3 << 3 | slopes(0) >> c.slopeBits - 3)
    )
  }
}
