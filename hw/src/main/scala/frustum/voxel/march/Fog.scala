package frustum.voxel.march

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** Fog, in which faces fade into the sky with their squared distance: a channel becomes
  * shown + (sky - shown) weight / 256, rounded down.
  */
object Fog {
  val WeightBits = 9

  /** Squared texels behind the fog's begin, 0 before it. */
  def beyond(config: VoxelConfig, far: UInt): UInt =
    Mux(far > config.fogSquared, far - config.fogSquared, U(0))

  /** Weight, of 256, from `beyond` times the configuration's `fogStep`. */
  def weight(config: VoxelConfig, product: UInt): UInt =
    if (config.fog) (product >> 16).resize(WeightBits) else U(0, WeightBits bits)

  /** sky - shown */
  def difference(sky: UInt, shown: UInt): SInt = (False ## sky).asSInt - (False ## shown).asSInt
}
