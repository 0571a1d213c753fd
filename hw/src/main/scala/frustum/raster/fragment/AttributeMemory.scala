package frustum.raster.fragment

import frustum.contract.raster.RasterConfig
import frustum.contract.raster.SetupWords.{PlaneA, PlaneB, PlaneG, PlaneR, PlaneZ}
import frustum.raster.scan.InterpolatedFragment
import spinal.core._
import spinal.lib._

/** Keeps a fragment's attributes until its texel is there, and its depth until the depth test. Fragments leave in
  * order: attributes at `fetch`, the depth later, at `fetchDepth`. Each is at the output from the next cycle until the
  * next fetch.
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
    val empty = out Bool () // no depth is kept
  }

  private def pointer(step: Bool): UInt = {
    val at = Reg(UInt(log2Up(AttributeMemory.Words) bits)) init 0
    when(step) { at := at + 1 }
    at
  }
  val written = pointer(io.push.valid)
  val fetched = pointer(io.fetch)
  val depthFetched = pointer(io.fetchDepth)

  // Colours that no state uses are not kept.
  private def kept(of: FragmentAttributes): Seq[Data] = Seq(of.x, of.y, of.tileEnd) ++
    Seq(PlaneR -> of.r, PlaneG -> of.g, PlaneB -> of.b, PlaneA -> of.a).collect { case (p, c) if wanted(p) => c }
  private def wanted(plane: Int) = config.fixed.planes.contains(plane)

  val pushed = FragmentAttributes(config, io.push.payload)
  val attributes = Mem(Bits(kept(pushed).map(widthOf(_)).sum bits), AttributeMemory.Words)
  attributes.write(written, Cat(kept(pushed)), io.push.valid)
  private val read = attributes.readSync(fetched, io.fetch, readUnderWrite = dontCare)
  io.attributes.assignDontCare()
  for ((to, at) <- kept(io.attributes).zip(kept(pushed).scanLeft(0)(_ + widthOf(_))))
    to.assignFromBits(read(at, widthOf(to) bits))

  if (wanted(PlaneZ)) {
    val depths = Mem(UInt(16 bits), AttributeMemory.Words)
    depths.write(written, FragmentAttributes.depth(io.push.z), io.push.valid)
    io.z := depths.readSync(depthFetched, io.fetchDepth, readUnderWrite = dontCare)
  } else io.z := 0

  io.empty := written === depthFetched
  assert(!(io.push.valid && written + 1 === depthFetched), "the attribute memory is full")
}

object AttributeMemory {
  val Words = 16
}
