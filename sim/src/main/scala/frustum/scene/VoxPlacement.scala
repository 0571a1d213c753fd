package frustum.scene

/** Where a node of a .vox scene graph puts what is below it: one of the 48 rotations and mirrors of the axes, then a
  * translation in voxels. Coordinate k of a placed point is `sign(k) * point(axis(k)) + shift(k)`.
  */
final case class VoxPlacement(axis: Seq[Int], sign: Seq[Int], shift: Seq[Int]) {

  /** A point whose coordinates, and those of the result, are in halves of a voxel. */
  def ofHalves(point: Seq[Int]): Seq[Int] = (0 to 2).map(k => sign(k) * point(axis(k)) + 2 * shift(k))

  /** First `inner`, then this. */
  def after(inner: VoxPlacement): VoxPlacement = VoxPlacement(
    axis.map(inner.axis),
    (0 to 2).map(k => sign(k) * inner.sign(axis(k))),
    (0 to 2).map(k => sign(k) * inner.shift(axis(k)) + shift(k))
  )

  /** The cell that the voxel at `cell` of a model goes to. The model turns about the corner of its voxel floor(size /
    * 2), which for odd sizes lies half a voxel off the middle; the cell is the one that the voxel's middle comes to.
    */
  def cell(size: Seq[Int], cell: Seq[Int]): Seq[Int] =
    ofHalves((0 to 2).map(k => 2 * (cell(k) - size(k) / 2) + 1)).map(half => Math.floorDiv(half, 2))
}

object VoxPlacement {
  val Identity: VoxPlacement = VoxPlacement(Seq(0, 1, 2), Seq(1, 1, 1), Seq(0, 0, 0))

  /** Greatest translation that is taken, in voxels: some thousand times the editor's space. */
  val MostShift: Int = 1 << 20

  /** The rotation of a `_r` attribute: bits 0-1 and 2-3 are the columns of the first two rows' entries, bits 4 to 6
    * the rows' signs, set where negative. None where two rows would have their entries in one column.
    */
  def rotation(packed: Int): Option[VoxPlacement] = {
    val (first, second) = (packed & 3, packed >> 2 & 3)
    Option.when(first < 3 && second < 3 && first != second)(VoxPlacement(
      Seq(first, second, 3 - first - second),
      Seq(4, 5, 6).map(bit => 1 - 2 * (packed >> bit & 1)),
      Seq(0, 0, 0)
    ))
  }
}
