package frustum.scene

import frustum.contract.InputError
import frustum.contract.voxel.WorldSize
import frustum.demos.voxel.Blocks
import frustum.files.InputFile
import java.nio.file.Path

/** Blocks of a world: their ids at x * sizeY * sizeZ + y * sizeZ + z, 0 is air. */
final case class VoxelWorld(size: WorldSize, ids: IndexedSeq[Byte]) {
  require(ids.length == size.blocks, s"${ids.length} ids for a world of $size")

  /** Outside the world there is air. */
  def apply(x: Int, y: Int, z: Int): Int = if (size.contains(x, y, z)) ids(size.address(x, y, z)).toInt else 0

  /** Height of the highest block of a column; 0 where there is none. */
  def surface(x: Int, y: Int): Int = (size.z - 1 to 0 by -1).find(z => this(x, y, z) != 0).getOrElse(0)

  def updated(x: Int, y: Int, z: Int, id: Int): VoxelWorld =
    copy(ids = ids.updated(size.address(x, y, z), id.toByte))
}

object VoxelWorld {

  /** @param id what is at x, y, z */
  def tabulate(size: WorldSize)(id: (Int, Int, Int) => Int): VoxelWorld = {
    val ids = new Array[Byte](size.blocks)
    for (x <- 0 until size.x; y <- 0 until size.y; z <- 0 until size.z)
      ids(size.address(x, y, z)) = id(x, y, z).toByte
    VoxelWorld(size, ids.toIndexedSeq)
  }

  /** Raw ids, a byte a block.
    *
    * @param most the highest id that means something
    */
  def readRaw(file: Path, size: WorldSize, most: Int): VoxelWorld = {
    val bytes = InputFile.bytes(file, "check the file")
    if (bytes.length != size.blocks) throw InputError(
      s"$file: has ${bytes.length} bytes, a world of $size has ${size.blocks}; give its size with --world-size"
    )
    val wrong = bytes.indexWhere(b => (b & 255) > most)
    if (wrong >= 0) throw InputError(
      s"$file: byte $wrong: id ${bytes(wrong) & 255} is above the table's highest, $most; " +
        "change the file or give another table with --blocks"
    )
    VoxelWorld(size, bytes.toIndexedSeq)
  }
}
