package frustum.scene

import frustum.contract.InputError
import frustum.contract.voxel.WorldSize
import java.nio.file.Path

/** Cells of a .vox scene: from `low` on, `size` of them along each axis. */
final case class VoxPart(low: Seq[Int], size: Seq[Int]) {
  override def toString: String = size.mkString("x")

  def fits(world: WorldSize): Boolean = size.zip(world.axes).forall { case (s, w) => s <= w }
  def contains(cell: Seq[Int]): Boolean = (0 to 2).forall(k => cell(k) >= low(k) && cell(k) < low(k) + size(k))
}

object VoxPart {

  /** What of a scene becomes the world: all of its models' boxes; where these are larger than the world, the box around
    * its voxels; with `crop`, the part from that cell of the models' boxes on.
    *
    * @param cells where its voxels are
    */
  def apply(
      file: Path,
      world: WorldSize,
      crop: Option[(Int, Int, Int)],
      instances: Seq[VoxInstance],
      cells: => Iterator[Seq[Int]]
  ): VoxPart = {
    val whole = around(instances.iterator.flatMap(_.corners))
    crop match {
      case Some((x, y, z)) =>
        val from = Seq(x, y, z)
        if ((0 to 2).exists(k => from(k) < 0 || from(k) >= whole.size(k)))
          throw InputError(s"--crop $x,$y,$z: lies outside of $file's scene of $whole voxels; give a place within it")
        VoxPart(
          (0 to 2).map(k => whole.low(k) + from(k)),
          (0 to 2).map(k => (whole.size(k) - from(k)).min(world.axes(k)))
        )
      case None if whole.fits(world) => whole
      case None                      =>
        val tight = around(cells)
        if (!tight.fits(world)) throw InputError(
          s"$file: has voxels in $tight of its $whole cells, more than the world of $world holds; ${remedy(tight)}"
        )
        tight
    }
  }

  private def around(cells: Iterator[Seq[Int]]): VoxPart = {
    val (low, high) = (Array.fill(3)(Int.MaxValue), Array.fill(3)(Int.MinValue))
    for (cell <- cells; k <- 0 to 2) {
      low(k) = low(k).min(cell(k))
      high(k) = high(k).max(cell(k))
    }
    VoxPart(low.toSeq, (0 to 2).map(k => high(k) - low(k) + 1))
  }

  /** The smallest world that holds a part, or how to take less of the scene. */
  private def remedy(part: VoxPart): String = {
    val crop = "take a part with --crop x,y,z"
    val sides = part.size.map(n => Integer.highestOneBit((n - 1).max(1)) * 2).map(_.max(WorldSize.Least))
    if (sides.forall(_ <= WorldSize.Most)) s"give --world-size ${sides.mkString("x")}, or $crop"
    else s"no world is larger than ${Seq.fill(3)(WorldSize.Most).mkString("x")}: $crop"
  }
}
