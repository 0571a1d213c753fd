package frustum.voxel.march

import frustum.contract.voxel.{BlockTable, VoxelConfig}
import spinal.core._

/** The place on a block's face that a ray has hit.
  *
  * @param slots rays that march at one time
  */
case class TexelHit(config: VoxelConfig, slots: Int) extends Bundle {
  val pixel = UInt(config.pixelBits bits)
  val pick = Bool()
  val slot = UInt(log2Up(slots) bits)
  val shown = Bool() // a face that is in view
  val last = Bool()
  val id = UInt(BlockTable.IdBits bits)
  val face = UInt(3 bits) // in order of travel: +x -x +y -y +z -z
  val block = Vec(UInt(config.size.logs.max bits), 3)
  val u, v = UInt(4 bits)
  val far = UInt(TexelHit.FarBits bits) // squared texels from the eye's texel

  /** Assigns all fields but those of the texel.
    *
    * @param distance the value of `far`
    */
  def follow(hit: FaceHit, distance: UInt): Unit = {
    pixel := hit.ray.pixel
    pick := hit.ray.pick
    slot := hit.slot
    shown := hit.face && distance <= config.farSquared
    last := hit.last
    id := hit.id
    far := distance
  }
}

object TexelHit {
  val FarBits = 22
}
