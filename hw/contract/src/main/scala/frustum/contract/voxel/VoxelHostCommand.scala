package frustum.contract.voxel

import frustum.contract.arithmetic.IntVector

/** Commands of a host to a board with a world, in bytes: an opcode, a payload, numbers with their highest byte first,
  * and a last byte that makes the sum of all 0 modulo 256. A pause of [[VoxelHostCommand.SilenceMicros]] ends an
  * incomplete command.
  */
object VoxelHostCommand {

  /** A word of the world's memory: address and word, three bytes each. The host provides the distances. */
  val Write: Int = 'W'
  val WriteBytes: Int = 6

  /** A block: address and id. The board computes the distances. */
  val Block: Int = 'B'

  /** A camera: eye, look, base, right, down, three components each of three bytes. The picture has no text over it. */
  val Camera: Int = 'C'
  val CameraBytes: Int = 45

  /** A camera, with which the face in the picture's middle is highlighted. */
  val Highlight: Int = 'H'

  /** Places the player, whose view is shown from then on: feet, yaw, pitch, see [[VoxelRules]]. */
  val Player: Int = 'P'

  val BlockBytes: Int = 6
  val PlayerBytes: Int = 15

  /** Bytes of each command's payload. */
  val bytesOf: Map[Int, Int] = Map(
    Write -> WriteBytes,
    Block -> BlockBytes,
    Camera -> CameraBytes,
    Highlight -> CameraBytes,
    Player -> PlayerBytes
  )
  val MostBytes: Int = bytesOf.values.max

  val SilenceMicros = 2000

  /** Opcode and checksum around a payload. */
  def bytes(opcode: Int, numbers: Seq[Int]): Seq[Int] = {
    val body = opcode +: numbers.flatMap(n => Seq(n >> 16 & 255, n >> 8 & 255, n & 255))
    body :+ (-body.sum & 255)
  }

  def write(address: Int, word: Int): Seq[Int] = bytes(Write, Seq(address, word))
  def block(address: Int, id: Int): Seq[Int] = bytes(Block, Seq(address, id))
  def camera(c: VoxelCamera): Seq[Int] = bytes(Camera, c.numbers)
  def highlight(c: VoxelCamera): Seq[Int] = bytes(Highlight, c.numbers)
  def player(feet: IntVector, yaw: Int, pitch: Int): Seq[Int] = bytes(Player, feet.axes ++ Seq(yaw, pitch))
}
