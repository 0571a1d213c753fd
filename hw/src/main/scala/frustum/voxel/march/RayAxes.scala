package frustum.voxel.march

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** Axes as a ray has them, its fast one first and the two others after it, against x, y, z; and coordinates in the
  * space that is mirrored for a ray so that all its components are positive: there axis k has size - coordinate.
  */
object RayAxes {

  /** The i-th of x, y, z in a ray's order. */
  def ordered[T <: Data](fast: UInt, xyz: collection.Seq[T], i: Int): T =
    fast.mux(0 -> xyz(i), 1 -> xyz((i + 1) % 3), default -> xyz((i + 2) % 3))

  /** Axis k of x, y, z from what is in a ray's order. */
  def xyz[T <: Data](fast: UInt, ordered: collection.Seq[T], k: Int): T =
    fast.mux(0 -> ordered(k), 1 -> ordered((k + 2) % 3), default -> ordered((k + 1) % 3))

  /** Number, 0 to 2, of the axis that is the i-th in a ray's order: fast + i modulo 3. */
  def number(fast: UInt, i: Int): UInt = ordered(fast, (0 to 2).map(U(_, 2 bits)), i)

  def number(fast: UInt, i: UInt): UInt = {
    val sum = fast +^ i
    Mux(sum >= 3, sum - 3, sum).resize(2)
  }

  /** The eye along axis k in mirrored space, `eyeBits` fraction bits. */
  def mirroredEye(config: VoxelConfig, mirrored: Bits, eye: collection.Seq[SInt], k: Int): SInt =
    mirror(mirrored(k), eye(k), farSide(config, k))

  /** The same for an axis that is known only in hardware.
    *
    * @param eye along that axis
    */
  def mirroredEye(config: VoxelConfig, mirrored: Bits, eye: SInt, k: UInt): SInt = {
    val none = S(0, config.blockBits + config.eyeBits bits)
    mirror(mirrored(k), eye, k.mux((0 to 2).map(n => n -> farSide(config, n)) :+ (default -> none): _*))
  }

  /** A block's coordinate along axis k, and a texel's within its block, mirrored or back. */
  def block(config: VoxelConfig, mirrored: Bits, block: UInt, k: Int): UInt =
    Mux(mirrored(k), U(config.size.axes(k) - 1, config.size.logs.max bits) - block, block)
  def texel(mirrored: Bits, texel: UInt, k: Int): UInt = Mux(mirrored(k), ~texel, texel)

  private def farSide(config: VoxelConfig, k: Int) =
    S(config.size.axes(k) << config.eyeBits, config.blockBits + config.eyeBits bits)
  private def mirror(mirrored: Bool, eye: SInt, farSide: SInt) = Mux(mirrored, farSide - eye, eye)
}
