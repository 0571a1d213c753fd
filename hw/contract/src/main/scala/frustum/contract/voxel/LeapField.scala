package frustum.contract.voxel

/** How far a ray may leap over air: for each block of air and each group of directions the side of the largest cube of
  * air with that block at its corner, the cube extending in the direction of travel. Outside the world is air.
  *
  * A direction's octant is the three signs of its components, x in bit 0, set where the component is negative. Octants
  * that agree in the bits of `mask` share a distance, the least of theirs: mask 0 is the Chebyshev distance, 7 a
  * distance per octant, 4 one for going up and one for going down.
  *
  * A word of the world's memory is the block's id with a bit above it set, or the distances less one, lowest group
  * lowest, with that bit clear: air needs no id and a block no distance.
  *
  * @param bits of a distance, which is at most 2^bits
  */
final case class LeapField(mask: Int, bits: Int) {
  require(mask >= 0 && mask < 8, s"LeapField: mask $mask is not a set of axes, 0 to 7")
  require(bits >= 0 && bits <= 4, s"LeapField: distances of $bits bits; 0 to 4 are supported")

  val most: Int = 1 << bits
  val axes: Seq[Int] = (0 until 3).filter(k => (mask >> k & 1) == 1)
  val groups: Int = 1 << axes.length
  val payload: Int = BlockTable.IdBits.max(groups * bits)
  val wordBits: Int = payload + 1
  require(
    wordBits <= 31,
    s"LeapField: $groups distances of $bits bits make a word of $wordBits bits; at most 31"
  )

  /** The group of an octant: its masked bits moved together. */
  def group(octant: Int): Int = axes.zipWithIndex.map { case (axis, i) => (octant >> axis & 1) << i }.sum

  /** Whether the octants of a group extend along +axis (1), -axis (-1) or both (0). */
  def side(group: Int, axis: Int): Int = axes.indexOf(axis) match {
    case -1 => 0
    case i  => 1 - 2 * (group >> i & 1)
  }

  def wordOfBlock(id: Int): Int = 1 << payload | id
  def wordOfAir(distances: Seq[Int]): Int = distances.zipWithIndex.map { case (d, g) =>
    (d - 1) << g * bits
  }.sum
  def isBlock(word: Int): Boolean = (word >> payload & 1) == 1
  def id(word: Int): Int = if (isBlock(word)) word & (1 << BlockTable.IdBits) - 1 else 0
  def distance(word: Int, octant: Int): Int = (word >> group(octant) * bits & most - 1) + 1
}

object LeapField {

  /** No leaps: one block per step. */
  val Plain = LeapField(mask = 0, bits = 0)

  /** One distance for all directions, a word of 6 bits. */
  val Chebyshev = LeapField(mask = 0, bits = 3)

  /** A word of 7 bits. */
  val UpDown = LeapField(mask = 4, bits = 3)

  /** One for each pair of signs along x and z, a word of 9 bits, as wide as block RAMs are. */
  val Quadrants = LeapField(mask = 5, bits = 2)

  /** A word of 17 bits. */
  val Octants = LeapField(mask = 7, bits = 2)
}
