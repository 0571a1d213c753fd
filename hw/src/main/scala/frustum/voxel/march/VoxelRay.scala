package frustum.voxel.march

import frustum.contract.voxel.{VoxelCamera, VoxelConfig}
import spinal.core._

/** A direction for each component: two's complement, [[frustum.contract.voxel.VoxelCamera.DirectionBits]] fraction
  * bits.
  */
case class Direction() extends Bundle {
  val axes = Vec(SInt(VoxelCamera.DirectionWidth bits), 3)
}

/** A camera at a frame's start; see [[frustum.contract.voxel.VoxelCamera]]. */
case class CameraPort(config: VoxelConfig) extends Bundle {
  val eye = Vec(SInt(config.blockBits + config.eyeBits bits), 3)
  val look, base, right, down = Direction()
}

/** The direction of a pixel. `pick` marks the ray that selects a block; it has no pixel. */
case class PixelRay(config: VoxelConfig) extends Bundle {
  val pixel = UInt(config.pixelBits bits)
  val pick = Bool()
  val direction = Direction()
}

/** The constants of a ray.
  *
  * Space is mirrored so that all components of the ray are positive. `fast` is the axis of the greatest one; index i of
  * the vectors is axis fast + 1 + i modulo 3. From a border of blocks across `fast` to the next, positions move on by
  * `slopes`. A position is one unit low where `low` says so, which puts crossings at one time into the order x, y, z.
  */
case class VoxelRay(config: VoxelConfig) extends Bundle {
  val pixel = UInt(config.pixelBits bits)
  val pick = Bool()
  val mirrored = Bits(3 bits)
  val fast = UInt(2 bits)
  val slopes = Vec(UInt(config.slopeBits bits), 2)
  val low = Bits(2 bits)
}

/** Place of a ray: `at` along the two other axes at the border `plane` of the fast one, and whether it has `past`
  * borders of theirs since.
  */
case class VoxelPlace(config: VoxelConfig) extends Bundle {
  val plane = SInt(config.blockBits bits)
  val at = Vec(SInt(config.blockBits + config.fractionBits bits), 2)
  val past = Bits(2 bits)
}

/** A ray ready to march: up to border `end`, beyond which everything is out of view. */
case class RayStart(config: VoxelConfig) extends Bundle {
  val ray = VoxelRay(config)
  val place = VoxelPlace(config)
  val end = SInt(config.endBits bits)
}

/** A hit of a ray: a face, unless it has left the world or the view. Nothing of a ray follows its `last` one.
  *
  * @param slots rays that march at one time
  */
case class FaceHit(config: VoxelConfig, slots: Int) extends Bundle {
  val ray = VoxelRay(config)
  val slot = UInt(log2Up(slots) bits)
  val face = Bool()
  val last = Bool()
  val id = UInt(frustum.contract.voxel.BlockTable.IdBits bits)
  val entry = UInt(2 bits) // axis of the border crossed: 0 the fast one, 1 and 2 the others
  val block = Vec(UInt(config.size.logs.max bits), 3) // in the order of `entry`, mirrored
  val at = Vec(SInt(config.blockBits + config.fractionBits bits), 2)
}
