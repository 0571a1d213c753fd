package frustum.demos.voxel

import frustum.contract.voxel.{BlockTable, BlockType, VoxelAssets}

/** The 24 kinds of block of the workbench. */
object Blocks {
  private def block(name: String, side: String, top: String, bottom: String) = {
    val Seq(s, t, b) = Seq(side, top, bottom).map(BlockArt.index)
    BlockType(name, Seq(s, s, s, s, b, t))
  }
  private def block(name: String): BlockType = block(name, name, name, name)

  val table: BlockTable = BlockTable(IndexedSeq(
    block("stone"),
    block("dirt"),
    block("grass", "grass side", "grass", "dirt"),
    block("sand"),
    block("gravel"),
    block("cobble"),
    block("planks"),
    block("log", "bark", "log end", "log end"),
    block("leaves").copy(opaque = false),
    block("water").copy(opaque = false, selectable = false, joins = true),
    block("glass").copy(opaque = false),
    block("brick"),
    block("snow", "snow side", "snow", "dirt"),
    block("ice").copy(opaque = false),
    block("coal"),
    block("iron"),
    block("gold"),
    block("bookshelf", "shelf", "planks", "planks"),
    block("red wool"),
    block("blue wool"),
    block("yellow wool"),
    block("lamp"),
    block("basalt"),
    block("cactus", "cactus side", "cactus", "cactus")
  ))

  val assets: VoxelAssets = VoxelAssets(table, BlockArt.textures)

  def id(name: String): Int =
    table.blocks.indexWhere(_.name == name).ensuring(_ >= 0, s"no block '$name'") + 1
}
