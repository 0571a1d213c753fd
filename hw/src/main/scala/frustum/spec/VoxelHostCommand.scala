package frustum.spec

/** What a host tells a board with a world, byte by byte: an opcode, a payload, numbers with their highest byte first, and a last byte that
  * makes the sum of all 0 modulo 256. A silence of [[VoxelHostCommand.SilenceMicros]] ends a command that was cut short.
  */
object VoxelHostCommand {

  /** A word of the world's memory: address and word, three bytes each. */
  val Write: Int      = 'W'
  val WriteBytes: Int = 6

  /** A camera: eye, look, base, right, down, three components each of three bytes. */
  val Camera: Int      = 'C'
  val CameraBytes: Int = 45

  val SilenceMicros = 2000

  /** Opcode and checksum around a payload. */
  def bytes(opcode: Int, numbers: Seq[Int]): Seq[Int] = {
    val body = opcode +: numbers.flatMap(n => Seq(n >> 16 & 255, n >> 8 & 255, n & 255))
    body :+ (-body.sum & 255)
  }

  def write(address: Int, word: Int): Seq[Int] = bytes(Write, Seq(address, word))
  def camera(c: VoxelCamera): Seq[Int]         = bytes(Camera, c.numbers)
}
