package frustum.ray.program

import frustum.contract.ray.RayProgram
import spinal.core._

/** The words of a row for its walkers: first `clear` for a cycle, then each word, `index` being its number, while
  * `valid`.
  */
case class RayRowLoad(program: RayProgram) extends Bundle {
  val clear, valid = Bool()
  val index = UInt(log2Up(program.loadWords.max(2)) bits)
  val data = Bits(program.wordWidth bits)
}
