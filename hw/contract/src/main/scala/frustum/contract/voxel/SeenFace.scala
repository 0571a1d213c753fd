package frustum.contract.voxel

/** A visible face of a world, and its texel: models and references are compared by it. */
final case class SeenFace(x: Int, y: Int, z: Int, id: Int, face: Int, u: Int, v: Int) {
  def sameBlock(o: SeenFace): Boolean = (x, y, z) == ((o.x, o.y, o.z))
  def sameFace(o: SeenFace): Boolean = sameBlock(o) && face == o.face
}
