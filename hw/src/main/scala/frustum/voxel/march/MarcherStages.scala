package frustum.voxel.march

import frustum.voxel.world.WorldReadBus

/** The nodes of the ring at which the parts of a step are computed; node 0 is the entrance.
  *
  * @param where   the block
  * @param look    for its word
  * @param steps   what the word means
  * @param far     where a leap ends
  * @param choose  where the ray is next
  * @param slots   rays in the ring, which has as many stages
  * @param retries whether memory and hits can be refused for a cycle
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

  /** Few registers: for about 25 MHz on an iCE40UP5K. */
  val Compact: MarcherStages = {
    val where = 1
    val look = where
    val steps = look + WorldReadBus.Latency + 1
    val far = steps
    val choose = far + 1
    MarcherStages(where, look, steps, far, choose, slots = choose, retries = true, narrow = true)
  }
}
