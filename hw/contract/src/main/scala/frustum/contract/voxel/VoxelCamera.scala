package frustum.contract.voxel

import frustum.contract.arithmetic.IntVector

/** A camera as the hardware takes it, at a frame's start.
  *
  * The direction of pixel (i, j), j downwards, is `base` + i `right` + j `down`, each component two's complement with
  * [[VoxelCamera.DirectionBits]] fraction bits, of magnitude below 2, and the greatest one at least 1/2; the direction
  * of the screen's centre is `look`.
  *
  * @param eye in blocks, [[VoxelConfig.eyeBits]] fraction bits
  */
final case class VoxelCamera(
    eye: IntVector,
    look: IntVector,
    base: IntVector,
    right: IntVector,
    down: IntVector
) {

  /** All numbers, in a host's order. */
  def numbers: Seq[Int] = Seq(eye, look, base, right, down).flatMap(_.axes)

  def direction(i: Int, j: Int): Seq[Int] =
    Seq((base.x, right.x, down.x), (base.y, right.y, down.y), (base.z, right.z, down.z)).map {
      case (b, r, d) =>
        b + i * r + j * d
    }
}

object VoxelCamera {
  val DirectionBits = 22

  /** Bits of a component, its sign among them. */
  val DirectionWidth = DirectionBits + 2

  /** A camera in the middle of the world that looks along +x, `focal` pixels from the screen. */
  def level(c: VoxelConfig, focal: Int): VoxelCamera = {
    val least = (c.width max c.height) / 4 + 1
    require(
      focal >= least,
      s"initial camera $focal pixels from a screen of ${c.width} x ${c.height}: rays at its edges reach 2 and " +
        s"overflow; at least $least"
    )
    val step = (1 << DirectionBits) / focal
    VoxelCamera(
      IntVector(c.size.x << c.eyeBits - 1, c.size.y << c.eyeBits - 1, c.size.z << c.eyeBits - 1),
      IntVector(1 << DirectionBits, 0, 0),
      IntVector(1 << DirectionBits, step * (c.width - 1) / 2, step * (c.height - 1) / 2),
      IntVector(0, -step, 0),
      IntVector(0, 0, -step)
    )
  }
}
