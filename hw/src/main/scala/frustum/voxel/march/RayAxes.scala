package frustum.voxel.march

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** Axes as a ray has them, its fast one first and the two others after it, against x, y, z. */
object RayAxes {

  /** The k-th of x, y, z in a ray's order. */
  def ordered[T <: Data](fast: UInt, xyz: collection.Seq[T], k: Int): T =
    fast.mux(0 -> xyz(k), 1 -> xyz((k + 1) % 3), default -> xyz((k + 2) % 3))

  /** Axis k of x, y, z from what is in a ray's order. */
  def xyz[T <: Data](fast: UInt, ordered: collection.Seq[T], k: Int): T =
    fast.mux(0 -> ordered(k), 1 -> ordered((k + 2) % 3), default -> ordered((k + 1) % 3))

  /** The eye along axis k in space mirrored for a ray. */
  def mirroredEye(c: VoxelConfig, mirrored: Bits, eye: collection.Seq[SInt], k: Int): SInt =
    Mux(mirrored(k), S(c.size.axes(k) << c.eyeBits, c.blockBits + c.eyeBits bits) - eye(k), eye(k))
}
