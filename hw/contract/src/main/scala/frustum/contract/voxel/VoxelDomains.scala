package frustum.contract.voxel

import frustum.contract.ValidFor

/** Ranges within which the methods of the world of blocks keep their error bounds. */
object VoxelDomains {
  val Layers = ValidFor("layers", "layers", "of water and glass", 1, 16, 12, "of 255")
  val FocalLength = ValidFor("march", "focal-length", "pixels, 320 x 240", 160, 700, 1.0 / 16, "pixels")
  val EyeOutside = ValidFor("march", "eye-outside", "blocks from the world", 0, VoxelConfig.Around, 0, "rays")
  val ViewDistance = ValidFor("march", "view-distance", "blocks", 1, VoxelConfig.MostDistance, 0, "rays")
}
