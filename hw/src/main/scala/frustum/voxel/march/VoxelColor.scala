package frustum.voxel.march

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** A pixel's colour, eight bits per channel. */
case class VoxelColor(config: VoxelConfig) extends Bundle {
  val pixel = UInt(config.pixelBits bits)
  val rgb = Vec(UInt(8 bits), 3)
}
