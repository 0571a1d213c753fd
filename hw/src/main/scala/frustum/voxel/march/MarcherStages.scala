package frustum.voxel.march

/** How a step is spread over clocks: which node of the ring does what; node 0 is the entrance.
  *
  * @param where the block; @param look for its word; @param steps what it means; @param far where a leap ends
  * @param choose where the ray is next
  * @param slots rays at work, stages of the ring
  * @param retries whether memory and hits may have to wait
  * @param narrow multipliers of 16 x 16 bits
  */
final case class MarcherStages(
    where: Int,
    look: Int,
    steps: Int,
    far: Int,
    choose: Int,
    slots: Int,
    retries: Boolean,
    narrow: Boolean
)

object MarcherStages {

  /** For devices whose logic is fast. */
  val Fast = MarcherStages(1, 2, 4, 5, 6, slots = 7, retries = false, narrow = false)

  /** As few registers as go with some 25 MHz on an iCE40UP5K. */
  val Compact = MarcherStages(1, 1, 3, 3, 4, slots = 4, retries = true, narrow = true)
}
