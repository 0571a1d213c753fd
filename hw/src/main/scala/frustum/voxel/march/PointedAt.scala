package frustum.voxel.march

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** The selected face. */
case class PointedAt(config: VoxelConfig) extends Bundle {
  val valid = Bool()
  val block = Vec(UInt(config.size.logs.max bits), 3)
  val face = UInt(3 bits)

  def is(hit: TexelHit): Bool = valid && face === hit.face && block === hit.block
}
