package frustum.contract.voxel

import scala.math.{ceil, sqrt}

/** A voxel renderer.
  *
  * Positions are in blocks with [[eyeBits]] fraction bits. A ray is given by the axis of its greatest component and by
  * its slopes against the two others, [[slopeBits]] fraction bits, below 1; see `frustum.voxel.march.VoxelRay`.
  *
  * @param distance view distance in blocks: what is farther from the eye is shown as sky
  * @param fog from three quarters of the view distance on, faces fade into the sky
  */
final case class VoxelConfig(
    size: WorldSize = WorldSize(64, 64, 32),
    width: Int = 320,
    height: Int = 240,
    leaps: LeapField = LeapField.UpDown,
    distance: Int = 24,
    fog: Boolean = true,
    slopeBits: Int = 15,
    eyeBits: Int = 8,
    sky: Int = 0xa0e0f0
) {
  require(width >= 16 && width <= 1024, s"width $width is not in 16..1024")
  require(height >= 16 && height <= 1024, s"height $height is not in 16..1024")
  require(slopeBits >= 12 && slopeBits <= 15, s"slopes of $slopeBits fraction bits; 12 to 15 are supported")
  require(eyeBits >= 4 && eyeBits <= 8, s"an eye of $eyeBits fraction bits; 4 to 8 are supported")
  require(
    distance >= 1 && distance <= VoxelConfig.MostDistance,
    s"view distance $distance is not in 1..${VoxelConfig.MostDistance}"
  )

  /** Fraction bits of a position along a ray's slower axes. */
  val fractionBits: Int = slopeBits + eyeBits

  /** Signed integer blocks: the world, [[VoxelConfig.Around]] blocks on either side of it, and a leap. */
  val blockBits: Int = 33 - Integer.numberOfLeadingZeros(size.axes.max + VoxelConfig.Around + leaps.most)

  /** Signed, of the last border that a ray may cross. */
  val endBits: Int = blockBits + 1
  val pixels: Int = width * height
  val pixelBits: Int = 32 - Integer.numberOfLeadingZeros(pixels)

  /** Slabs a ray may cross until the rest of it is out of view, by the top three bits of its slopes. A point d away
    * from the eye is d / sqrt(1 + a^2 + b^2) along the fastest axis; a slab more for the fraction of the eye's.
    */
  val slabs: Seq[Int] = for (b <- 0 until 8; a <- 0 until 8)
    yield ceil(distance / sqrt(1 + a * a / 64.0 + b * b / 64.0)).toInt + 1

  /** Squared view distance in texels; where fog begins; and what a squared texel adds to the fog's weight of 256, in
    * 2^-16.
    */
  val farSquared: Int = square(16 * distance)
  val fogSquared: Int = square(12 * distance)
  val fogStep: Int = (256 << 16) / (farSquared - fogSquared)
  private def square(n: Int) = n * n

  /** Red, green and blue of the sky. */
  val skyChannels: Seq[Int] = VoxelConfig.channels(sky)
}

object VoxelConfig {

  /** Red, green and blue of 0xRRGGBB. */
  def channels(rgb: Int): Seq[Int] = Seq(16, 8, 0).map(rgb >> _ & 255)

  val MostDistance = 60

  /** Blocks within which a face can be selected. */
  val Reach = 6

  /** Blocks around the world in which the eye may be. */
  val Around = 32

  /** Light of the faces in order of travel, of 256: the top has the most. */
  val Light: Seq[Int] = Seq(208, 208, 176, 176, 128, 256)
}
