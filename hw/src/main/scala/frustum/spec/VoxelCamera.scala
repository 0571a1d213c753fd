package frustum.spec

/** A camera as the hardware takes it, at a frame's start.
  *
  * The direction of pixel (i, j), j downwards, is `base` + i `right` + j `down`, each component two's complement with
  * [[VoxelCamera.DirectionBits]] fraction bits, of magnitude below 2, and the greatest one at least 1/2; the direction of the screen's centre is `look`.
  *
  * @param eye in blocks, [[VoxelConfig.eyeBits]] fraction bits
  */
final case class VoxelCamera(eye: IntVector, look: IntVector, base: IntVector, right: IntVector, down: IntVector) {

  def direction(i: Int, j: Int): Seq[Int] =
    Seq((base.x, right.x, down.x), (base.y, right.y, down.y), (base.z, right.z, down.z)).map { case (b, r, d) =>
      b + i * r + j * d
    }
}

object VoxelCamera {
  val DirectionBits = 22

  /** With the sign. */
  val DirectionWidth = DirectionBits + 2
}
