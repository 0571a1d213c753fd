package frustum.voxel.world

import frustum.contract.voxel.{BlockTable, LeapField}
import spinal.core._

/** The meaning of a word of the world's memory, by the layout of [[frustum.contract.voxel.LeapField]]. */
object LeapWord {

  /** Bits of a cube's side. */
  val SideBits = 5

  def isBlock(word: Bits): Bool = word.msb

  /** Id of the block that a word is of. */
  def id(word: Bits): UInt = word(BlockTable.IdBits - 1 downto 0).asUInt

  /** Side of the largest cube of air in a group's directions, from a word of air.
    *
    * @param group is ignored where the field has only one
    */
  def side(field: LeapField, word: Bits, group: => UInt): UInt =
    if (field.bits == 0) U(1, SideBits bits)
    else {
      val distances = word(field.groups * field.bits - 1 downto 0).subdivideIn(field.groups slices)
      (if (field.groups == 1) distances(0) else distances(group)).asUInt.resize(SideBits) + 1
    }

  /** The word of a block; of air, id 0, one without leaps. */
  def of(field: LeapField, id: UInt): Bits = {
    val block = B(1 << field.payload, field.wordBits bits) | id.asBits.resize(field.wordBits)
    Mux(id =/= 0, block, B(0, field.wordBits bits))
  }
}
