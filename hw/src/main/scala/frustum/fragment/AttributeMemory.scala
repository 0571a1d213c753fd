package frustum.fragment

import frustum.raster.InterpolatedFragment
import frustum.spec.RasterConfig
import spinal.core._
import spinal.lib._

/** Where a fragment's attributes wait for its texel, and its depth for the depth test: fragments leave in
  * order, attributes when `fetch` says so and the depth later, at `fetchDepth`. Each is shown the clock after
  * and until the next.
  *
  * It is never full: the stages between hold twelve fragments at most.
  */
case class AttributeMemory(config: RasterConfig) extends Component {
  val io = new Bundle {
    val push = slave(Flow(InterpolatedFragment(config)))
    val fetch = in Bool ()
    val attributes = out(FragmentAttributes(config))
    val fetchDepth = in Bool ()
    val z = out UInt (16 bits)
    val empty = out Bool () // no depth waits
  }

  private def pointer(step: Bool): UInt = {
    val at = Reg(UInt(log2Up(AttributeMemory.Words) bits)) init 0
    when(step) { at := at + 1 }
    at
  }
  val written = pointer(io.push.valid)
  val fetched = pointer(io.fetch)
  val depthFetched = pointer(io.fetchDepth)

  val attributes = Mem(FragmentAttributes(config), AttributeMemory.Words)
  attributes.write(written, FragmentAttributes(config, io.push.payload), io.push.valid)
  io.attributes := attributes.readSync(fetched, io.fetch, readUnderWrite = dontCare)

  val depths = Mem(UInt(16 bits), AttributeMemory.Words)
  depths.write(written, FragmentAttributes.depth(io.push.z), io.push.valid)
  io.z := depths.readSync(depthFetched, io.fetchDepth, readUnderWrite = dontCare)

  io.empty := written === depthFetched
  assert(!(io.push.valid && written + 1 === depthFetched), "the attribute memory is full")
}

object AttributeMemory {
  val Words = 16
}
