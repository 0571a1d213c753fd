package frustum.contract.voxel

/** Textures of 16 x 16 texels for the faces of blocks, each with a palette of 16 colours of its own, RGBA4444, red
  * highest, alpha 15 opaque.
  *
  * @param indices of each texture, row by row from the top
  */
final case class VoxelTextures(indices: IndexedSeq[IndexedSeq[Int]], palettes: IndexedSeq[IndexedSeq[Int]]) {
  import VoxelTextures._
  require(
    indices.length == palettes.length && indices.length <= Most,
    s"${indices.length} textures; at most $Most"
  )
  require(
    indices.forall(t => t.length == Side * Side && t.forall(i => i >= 0 && i < Colors)),
    "a texture does not have 16 x 16 texels"
  )
  require(
    palettes.forall(p => p.length == Colors && p.forall(c => c >= 0 && c >> 16 == 0)),
    "a palette does not have 16 colours"
  )

  /** RGBA4444 of a texel, v downwards. */
  def apply(texture: Int, u: Int, v: Int): Int = palettes(texture)(indices(texture)(v * Side + u))
}

object VoxelTextures {
  val Side = 16
  val Colors = 16
  val Most = 32
}
