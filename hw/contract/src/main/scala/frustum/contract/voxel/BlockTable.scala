package frustum.contract.voxel

/** A kind of block. Faces are in the order of travel of the ray that meets them: +x, -x, +y, -y, +z (the bottom), -z
  * (the top).
  *
  * @param textures one for each face
  * @param opaque rays end here: no texel of it lets light through
  * @param selectable whether it can be selected
  * @param joins adjoining blocks of this kind show one layer, as a body of water
  */
final case class BlockType(
    name: String,
    textures: Seq[Int],
    opaque: Boolean = true,
    selectable: Boolean = true,
    joins: Boolean = false
) {
  require(textures.length == 6, s"block '$name' has ${textures.length} textures; there are 6 faces")
}

/** What ids mean. Id 0 is air; block i of `blocks` has id i + 1. */
final case class BlockTable(blocks: IndexedSeq[BlockType]) {
  require(blocks.length <= BlockTable.Most, s"${blocks.length} kinds of block; at most ${BlockTable.Most}")
  def apply(id: Int): BlockType = blocks(id - 1)
  def ids: Range = 1 to blocks.length
}

object BlockTable {
  val IdBits = 5
  val Most = (1 << IdBits) - 1
}
