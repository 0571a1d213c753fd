package frustum.voxel.march

import frustum.contract.voxel.VoxelConfig
import spinal.core._

/** Which texel of a block a ray meets. Pairs and triples are in the ray's order, the fast axis first, mirrored.
  *
  * On a border of the fast axis the texel follows from the position. On another axis' border the ray is where it was at
  * the last border of the fast axis, plus run / slope along the fast axis and run * otherSlope / slope along the third,
  * run being the distance to the border: four digits of two divisions, exact. Divided are
  * {{{run / (slope 2^eyeBits)     and     (side slope + run otherSlope) / (slope 2^fractionBits)}}} with side the
  * position along the third axis.
  */
object FacePlace {

  /** Binary digits of a texel's place in its block. */
  val Digits = 4

  /** Bits of a position from a block's corner. */
  def withinBits(config: VoxelConfig): Int = config.fractionBits + 2

  /** Position along the i-th other axis from the corner of the block that is met. */
  def within(config: VoxelConfig, hit: FaceHit, i: Int): SInt = {
    val at = hit.at(i) + hit.ray.low(i).asUInt.resize(config.blockBits + config.fractionBits).asSInt
    val corner = (hit.block(i + 1)(1 downto 0) ## B(0, config.fractionBits bits)).asSInt
    at.resize(withinBits(config)) - corner
  }

  // Where a border of another axis than the fast one is met: the one of a pair that belongs to this axis, and the
  // other one.
  def own[T <: Data](entry: UInt, pair: collection.Seq[T]): T = Mux(entry === 2, pair(1), pair(0))
  def other[T <: Data](entry: UInt, pair: collection.Seq[T]): T = Mux(entry === 2, pair(0), pair(1))

  /** A position as a texel, on a border of the fast axis; at most the block's last. */
  def straight(config: VoxelConfig, within: SInt): UInt = {
    val sixteenth = within(config.fractionBits downto config.fractionBits - Digits).asUInt
    Mux(sixteenth.msb, U(15, Digits bits), sixteenth(Digits - 1 downto 0))
  }

  /** The texel: on the border that was met it is the first.
    *
    * @param along,across the quotients
    */
  def texel(entry: UInt, straight: collection.Seq[UInt], along: UInt, across: UInt): Vec[UInt] = Vec(
    Mux(entry === 0, U(0), along),
    entry.mux(0 -> straight(0), 1 -> U(0, Digits bits), default -> across),
    entry.mux(0 -> straight(1), 1 -> across, default -> U(0, Digits bits))
  )

  /** Texels from the eye's to this one along an axis. */
  def away(config: VoxelConfig, block: UInt, texel: UInt, eye: SInt): SInt = {
    val bits = config.blockBits + Digits + 1
    (block @@ texel).resize(bits).asSInt - (eye >> config.eyeBits - Digits).resize(bits)
  }

  /** Which face of a block is met, in order of travel: +x -x +y -y +z -z. */
  def face(hit: FaceHit): UInt = {
    val axis = RayAxes.number(hit.ray.fast, hit.entry)
    axis @@ hit.ray.mirrored(axis)
  }

  /** u and v of a texel within its block, x, y, z, on a face. */
  def uv(face: UInt, texel: collection.Seq[UInt]): (UInt, UInt) = {
    val (x, y, z) = (texel(0), texel(1), texel(2))
    (face.mux(0 -> ~y, 1 -> y, 2 -> x, 3 -> ~x, 4 -> x, default -> ~x), Mux(face(2), y, ~z))
  }
}
