package frustum.referee

import frustum.scene.VoxelWorld

/** Which block is where, from the bytes of a world by the contract of the command line: one byte a block, at
  * x * sizeY * sizeZ + y * sizeZ + z. Around the world there is air.
  */
final class WorldBlocks(world: VoxelWorld) {
  private val Seq(sizeX, sizeY, sizeZ) = world.size.axes

  def apply(x: Int, y: Int, z: Int): Int =
    if (x < 0 || x >= sizeX || y < 0 || y >= sizeY || z < 0 || z >= sizeZ) 0
    else world.ids(x * sizeY * sizeZ + y * sizeZ + z) & 255
}
