package frustum.scene

import frustum.contract.InputError
import frustum.contract.voxel.{VoxelAssets, WorldSize}
import frustum.files.Notices
import java.nio.file.Path

/** How a .vox file becomes a world.
  *
  * @param crop   where in the scene the part begins that is taken, voxels from the low corner of its models' boxes
  * @param opaque glass is solid
  * @param blocks offered for the colours
  * @param keep   all of `blocks` stay in the table, under their ids
  * @param grow   plain blocks may be added to them
  */
final case class VoxOptions(
    blocks: VoxelAssets,
    crop: Option[(Int, Int, Int)] = None,
    opaque: Boolean = false,
    keep: Boolean = false,
    grow: Boolean = true
)

/** Reads MagicaVoxel's .vox as a world of blocks: the scene, z up, stands in the middle of the world's ground. Where
  * models overlap the later one is seen. `docs/voxel-files.md` tells what is read, left out and refused.
  */
object VoxFile {

  /** Voxels of a scene at most, counted in every instance. */
  private val MostVoxels = 1L << 26

  def read(file: Path, size: WorldSize, options: VoxOptions, notices: Notices): (VoxelWorld, VoxelAssets) = {
    val content = VoxChunks.read(file)
    val instances = VoxScene.instances(file, content, notices)
    val voxels = instances.map(_.model.voxels.length.toLong).sum
    if (voxels > MostVoxels)
      throw InputError(s"$file: has $voxels voxels in its scene, at most $MostVoxels; show fewer models")
    def cells = for (i <- instances.iterator; v <- i.model.voxels.iterator) yield (i.cell(v), v.color)

    val part = VoxPart(file, size, options.crop, instances, cells.map(_._1))
    val corner = (0 to 2).map(k => if (k == 2) 0 else (size.axes(k) - part.size(k)) / 2)
    val colors = new Array[Int](size.blocks)
    var cut = 0L
    for ((cell, color) <- cells)
      if (part.contains(cell)) {
        val Seq(x, y, z) = (0 to 2).map(k => cell(k) - part.low(k) + corner(k))
        colors(size.address(x, y, z)) = color
      } else cut += 1
    notices.add(s"$file: voxels outside of the part of $part that --crop takes", cut)
    if (colors.forall(_ == 0)) throw InputError(s"--crop: there is no voxel in the part of $part; take another part")
    blocks(file, size, colors, content, options, notices)
  }

  /** The world of the cells' colour indices, 0 being air, and the blocks that it is built of. */
  private def blocks(
      file: Path,
      size: WorldSize,
      colors: Array[Int],
      content: VoxContent,
      options: VoxOptions,
      notices: Notices
  ): (VoxelWorld, VoxelAssets) = {
    val used = colors.groupMapReduce(identity)(_ => 1)(_ + _).removed(0)
    def look(color: Int) = {
      val glass = content.materials.get(color).filter(_.kind == "glass" && !options.opaque)
      BlockColor(content.palette(color), glass.fold(0.0)(_.seeThrough.max(1e-6)))
    }
    val looks = used.keys.map(color => color -> look(color)).toMap
    // The most frequent first; of equally frequent ones that of the lower index.
    val wanted = used.keys.toSeq.groupBy(looks).toSeq
      .sortBy { case (_, same) => (-same.map(used).sum, same.min) }.map(_._1)
    val chosen = ColorBlocks.choose(wanted, options.blocks, options.keep, options.grow).getOrElse(throw InputError(
      s"$file: none of the blocks is opaque, so its voxels have none; set \"opaque\": true in one of --blocks"
    ))
    notices.add(
      s"$file: colours of ${wanted.length} shown in that of the nearest of ${chosen.assets.table.blocks.length} blocks",
      chosen.nearest
    )
    val plain = Set("diffuse", "glass")
    notices.add(
      s"$file: colours whose material is neither diffuse nor glass, drawn without it",
      used.keys.count(color => content.materials.get(color).exists(m => !plain(m.kind)))
    )
    val ids = IndexedSeq.tabulate(256)(color => looks.get(color).fold(0)(chosen.ids).toByte)
    (VoxelWorld(size, colors.map(ids).toIndexedSeq), chosen.assets)
  }
}
