package frustum.voxel.world

import frustum.contract.voxel.WorldSize
import spinal.core._

/** Places of blocks against a world: coordinates x, y, z, signed, of any width that holds the world's sides. As these
  * are powers of two, the upper bits show whether a place is outside, and its address is the concatenation of the lower
  * ones.
  */
object WorldPlace {

  /** Coordinate k is on or behind the world's far side. */
  def beyond(size: WorldSize, coordinate: SInt, k: Int): Bool =
    !coordinate.msb && (coordinate >> size.logs(k)) =/= 0

  def inside(size: WorldSize, place: collection.Seq[SInt]): Bool =
    (0 to 2).map(k => !place(k).msb && (place(k) >> size.logs(k)) === 0).reduce(_ && _)

  /** Address of a place in the world's memory; it is undefined outside the world. */
  def address[T <: BitVector](size: WorldSize, place: collection.Seq[T]): UInt =
    Cat((2 to 0 by -1).map(k => place(k).asBits(size.logs(k) - 1 downto 0))).asUInt

  /** Coordinate k of an address. */
  def coordinate(size: WorldSize, address: UInt, k: Int): UInt =
    address(size.logs.drop(k).sum - 1 downto size.logs.drop(k + 1).sum)
}
