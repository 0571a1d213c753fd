package frustum.voxel.march

import frustum.arithmetic.LockstepPipeline
import frustum.contract.voxel.VoxelConfig
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Where on its face a ray has met a block.
  *
  * @param face
  *   in order of travel: +x -x +y -y +z -z
  */
case class TexelHit(c: VoxelConfig, slots: Int) extends Bundle {
  val pixel = UInt(c.pixelBits bits)
  val pick = Bool()
  val slot = UInt(log2Up(slots) bits)
  val shown = Bool() // a face, and in view
  val last = Bool()
  val id = UInt(frustum.contract.voxel.BlockTable.IdBits bits)
  val face = UInt(3 bits)
  val block = Vec(UInt(c.size.logs.max bits), 3)
  val u, v = UInt(4 bits)
  val far = UInt(TexelHit.FarBits bits) // squared texels from the eye's texel
}

object TexelHit {
  val FarBits = 22

  /** u and v of a texel within its block, x, y, z, on a face. */
  def uv(face: UInt, inside: collection.Seq[UInt]): (UInt, UInt) = {
    val (x, y, z) = (inside(0), inside(1), inside(2))
    (face.mux(0 -> ~y, 1 -> y, 2 -> x, 3 -> ~x, 4 -> x, default -> ~x), Mux(face(2), y, ~z))
  }
}
