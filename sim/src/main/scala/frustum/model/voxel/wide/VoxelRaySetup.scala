package frustum.model.voxel.wide

import frustum.contract.arithmetic.ReciprocalTable
import frustum.contract.voxel.{VoxelCamera, VoxelConfig}
import frustum.model.voxel.march.{RayAxes, RayStart}

object VoxelRaySetup {
  private val Bits = VoxelCamera.DirectionBits

  /** |minor / major| with 15 fraction bits by the reciprocal of the major's mantissa, 1 / (1 + f) = 1 - r / 2. */
  private def slope(minor: Int, major: Int, c: VoxelConfig): Int = {
    val half = major >> Bits == 0 // below 1, at least 1/2
    val fraction = (if (half) major >> 1 else major >> 2) & (1 << 20) - 1
    val v = if (half) minor >> 6 else minor >> 7
    val quotient = v - (v.toLong * ReciprocalTable(fraction) >> 17).toInt
    quotient.min((1 << 15) - 1) >> 15 - c.slopeBits
  }

  def apply(eye: Seq[Int], direction: Seq[Int], c: VoxelConfig): RayStart = {
    val mirrored = direction.map(_ < 0)
    val magnitude = direction.map(_.abs)
    require(
      magnitude.max >> Bits - 1 != 0 && magnitude.max >> Bits + 1 == 0,
      s"direction $direction is out of range"
    )
    val fast = magnitude.indexOf(magnitude.max)
    val others = RayAxes.others(fast)
    val slopes = others.map(k => slope(magnitude(k), magnitude(fast), c))
    val p = (0 to 2).map(RayAxes.mirroredEye(c, mirrored, eye, _))
    val behind = p(fast) & (1 << c.eyeBits) - 1
    val at = others.zip(slopes).map { case (k, s) =>
      (p(k).toLong << c.slopeBits) - s.toLong * behind - (if (k > fast && s != 0) 1 else 0)
    }
    RayStart(
      mirrored,
      fast,
      slopes,
      p(fast) >> c.eyeBits,
      at,
      others.zip(at).map { case (k, a) => (a >> c.fractionBits) < (p(k) >> c.eyeBits) },
      c.slabs(slopes(1) >> c.slopeBits - 3 << 3 | slopes(0) >> c.slopeBits - 3)
    )
  }
}
