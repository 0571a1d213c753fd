package frustum.demos.voxel

import frustum.contract.voxel.VoxelConfig
import frustum.voxel.march.PointedAt
import frustum.voxel.world.WorldPlace
import spinal.core._

/** The block that a player's hand is at: the selected one, to destroy it, or the one before its face, to place one
  * there.
  *
  * @param low,high blocks that the player's body reaches into
  */
class PlayerHand(config: VoxelConfig, at: PointedAt, destroy: Bool, low: Vec[SInt], high: Vec[SInt]) extends Area {
  private val logs = config.size.logs
  private val axis = at.face >> 1
  private val target = Vec((0 to 2).map { k =>
    val block = at.block(k).resize(logs(k) + 2).asSInt
    // a ray that goes up meets the bottom
    Mux(axis === k, Mux(at.face.lsb, block + 1, block - 1), block).resize(config.blockBits)
  })
  private val outside = !WorldPlace.inside(config.size, target)
  private val within = (0 to 2).map(k => target(k) >= low(k) && target(k) <= high(k)).reduce(_ && _)

  /** Nothing can be placed: outside of the world, or within the body. */
  val refuses = RegNext(outside || within)

  val address = RegNext(WorldPlace.address(
    config.size,
    (0 to 2).map(k => Mux(destroy, at.block(k).resize(logs(k)), target(k).asUInt.resize(logs(k))))
  ))
}
