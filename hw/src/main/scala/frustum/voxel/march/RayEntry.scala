package frustum.voxel.march

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** Where a ray starts: taken back from the eye to the last border of blocks across its fast axis, exactly. The eye is
  * that in mirrored space, along one axis.
  */
object RayEntry {

  /** Border from which the ray starts, and the eye's way from there, along the fast axis. */
  def plane(config: VoxelConfig, eye: SInt): SInt = eye >> config.eyeBits
  def behind(config: VoxelConfig, eye: SInt): UInt = eye(config.eyeBits - 1 downto 0).asUInt

  /** Whether positions along the i-th other axis are a unit low, see [[VoxelRay]]: where it is a later axis than the
    * fast one, and the ray moves along it.
    */
  def low(fast: UInt, slope: UInt, i: Int): Bool = (if (i == 0) fast =/= 2 else fast === 0) && slope =/= 0

  /** Position along another axis at the start.
    *
    * @param back slope times `behind`
    */
  def at(config: VoxelConfig, eye: SInt, back: Bits, low: Bool): SInt =
    (eye ## B(0, config.slopeBits bits)).asSInt -
      (back(config.fractionBits downto 0).asUInt + low.asUInt).resize(config.fractionBits + 2).asSInt

  /** Whether the ray has passed a border of that axis from there to the eye. */
  def past(config: VoxelConfig, at: SInt, eye: SInt): Bool = (at >> config.fractionBits) =/= (eye >> config.eyeBits)

  /** Last border that the ray may cross, see [[frustum.contract.voxel.VoxelConfig.slabs]]. */
  def end(config: VoxelConfig, plane: SInt, slopes: collection.Seq[UInt]): SInt = {
    val steep = slopes.map(_(config.slopeBits - 1 downto config.slopeBits - 3))
    val slabs = Vec(config.slabs.map(U(_, 7 bits)))(steep(1) @@ steep(0))
    plane.resize(config.endBits) + slabs.resize(config.endBits).asSInt
  }
}
