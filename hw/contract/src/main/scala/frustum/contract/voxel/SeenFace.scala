package frustum.contract.voxel

/** A face of a world that a ray sees, and the texel of it: what models and references are compared by. */
final case class SeenFace(x: Int, y: Int, z: Int, id: Int, face: Int, u: Int, v: Int) {
  def sameBlock(o: SeenFace): Boolean = (x, y, z) == ((o.x, o.y, o.z))
  def sameFace(o: SeenFace): Boolean = sameBlock(o) && face == o.face
}
