package frustum.voxel.march

import frustum.voxel.world.WorldReadBus

/** How a step is spread over cycles: which node of the ring does what; node 0 is the entrance.
  *
  * @param where   the block
  * @param look    for its word
  * @param steps   what the word means
  * @param far     where a leap ends
  * @param choose  where the ray is next
  * @param slots   rays at work, stages of the ring
  * @param retries whether memory and hits may have to wait
  * @param narrow  multipliers of 16 x 16 bits
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
) {

  /** The word is there. */
  val decide: Int = look + WorldReadBus.Latency
}

object MarcherStages {

  /** A register behind each, on devices whose logic is fast. */
  val Fast: MarcherStages = {
    val where = 1
    val look = where + 1
    val steps = look + WorldReadBus.Latency + 1
    val far = steps + 1
    val choose = far + 1
    MarcherStages(where, look, steps, far, choose, slots = choose + 1, retries = false, narrow = false)
  }

  /** Few registers: what goes with some 25 MHz on an iCE40UP5K. */
  val Compact: MarcherStages = {
    val where = 1
    val look = where
    val steps = look + WorldReadBus.Latency + 1
    val far = steps
    val choose = far + 1
    MarcherStages(where, look, steps, far, choose, slots = choose, retries = true, narrow = true)
  }
}
