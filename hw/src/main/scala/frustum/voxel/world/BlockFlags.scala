package frustum.voxel.world

import frustum.contract.voxel.{BlockTable, BlockType}
import spinal.core._

/** Properties of blocks as bits by id; ids that are not in the table have none. */
case class BlockFlags(table: BlockTable) {
  def where(property: BlockType => Boolean): Bits =
    B(table.ids.filter(id => property(table(id))).map(BigInt(1) << _).sum, BlockTable.Most + 1 bits)
}
