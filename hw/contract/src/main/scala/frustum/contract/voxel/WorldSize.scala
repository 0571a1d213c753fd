package frustum.contract.voxel

/** Blocks of a voxel world along each axis, z up. Powers of two, so that an address is the concatenation of the
  * coordinates: x * sizeY * sizeZ + y * sizeZ + z.
  */
final case class WorldSize(x: Int, y: Int, z: Int) {
  WorldSize.fault(x, y, z).foreach(fault => throw new IllegalArgumentException(fault))

  val axes: Seq[Int] = Seq(x, y, z)
  val logs: Seq[Int] = axes.map(Integer.numberOfTrailingZeros)
  val blocks: Int = x * y * z
  val addressBits: Int = logs.sum
  override def toString = s"${x}x${y}x$z"

  def contains(bx: Int, by: Int, bz: Int): Boolean =
    bx >= 0 && bx < x && by >= 0 && by < y && bz >= 0 && bz < z
  def address(bx: Int, by: Int, bz: Int): Int = {
    require(contains(bx, by, bz), s"block ($bx, $by, $bz) is outside the world of $this")
    (bx * y + by) * z + bz
  }
}

object WorldSize {
  val Least = 4
  val Most = 128

  /** The rule that a size breaks, with the remedy, or None. */
  def fault(x: Int, y: Int, z: Int): Option[String] =
    if (Seq(x, y, z).forall(n => n >= Least && n <= Most && Integer.bitCount(n) == 1)) None
    else Some(s"a world of ${x}x${y}x$z blocks: each side must be a power of two from $Least to $Most")
}
