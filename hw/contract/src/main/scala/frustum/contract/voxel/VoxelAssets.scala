package frustum.contract.voxel

/** Block table and textures: what a picture needs in addition to the world. */
final case class VoxelAssets(table: BlockTable, textures: VoxelTextures) {
  for (id <- table.ids; t <- table(id).textures) require(
    t >= 0 && t < textures.indices.length,
    s"block '${table(id).name}' has texture $t; there are ${textures.indices.length}"
  )
  for (id <- table.ids if table(id).opaque; t <- table(id).textures) require(
    textures.indices(t).forall(i => (textures.palettes(t)(i) & 15) == 15),
    s"block '${table(id).name}' is opaque, but texture $t is not"
  )
}
