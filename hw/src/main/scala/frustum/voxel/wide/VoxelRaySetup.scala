package frustum.voxel.wide

import frustum.arithmetic.{LockstepPipeline, Multiplier16}
import frustum.contract.arithmetic.ReciprocalTable
import frustum.contract.voxel.VoxelConfig
import frustum.device.Tech
import frustum.voxel.march.{PixelRay, RayAxes, RayStart}
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Start of a ray from its direction, one a clock, latency 12 clocks, 5 multipliers.
  *
  *   1. `fast` is the axis of the greatest component, the first of equal ones
  *   1. slopes: |other| / |fast| = v (1 - r / 2), with 1 + f the mantissa of |fast|, v the other one to its scale, and
  *      r = 2 f / (1 + f) from [[frustum.contract.arithmetic.ReciprocalTable]]; cut to the bits wanted and below 1. Error
  *      below 2.5 2^-15
  *   1. the ray is taken back from the eye to the border of blocks behind it, exactly
  *
  * The model is `frustum.model.voxel.wide.VoxelRaySetup`.
  */
case class VoxelRaySetup(c: VoxelConfig, tech: Tech) extends Component {
  val io = new Bundle {
    val eye = in Vec (SInt(c.blockBits + c.eyeBits bits), 3)
    val up = slave(Stream(PixelRay(c)))
    val down = master(Stream(RayStart(c)))
  }
  val line = new LockstepPipeline(12)
  val enable = line.enable

  val RAY = Payload(PixelRay(c))
  val MIRRORED = Payload(Bits(3 bits))
  val MAGNITUDE = Payload(Vec(UInt(23 bits), 3))
  val FAST = Payload(UInt(2 bits))
  val MAJOR = Payload(UInt(23 bits))
  val MINOR = Payload(Vec(UInt(23 bits), 2))
  val SCALED = Payload(Vec(UInt(16 bits), 2))
  val INDEX = Payload(UInt(8 bits))
  val FRACTION = Payload(UInt(12 bits))
  val SLOPE = Payload(Vec(UInt(c.slopeBits bits), 2))
  val FROM = Payload(Vec(SInt(c.blockBits + c.eyeBits bits), 3)) // the eye, mirrored, fast axis first
  val AT = Payload(Vec(SInt(c.blockBits + c.fractionBits bits), 2))
  val LOW = Payload(Bits(2 bits))
  val END = Payload(SInt(c.endBits bits))

  line(0).driveFrom(io.up)((node, payload) => node(RAY) := payload)
  for (k <- 0 to 2) {
    val d = io.up.direction.axes(k)
    line(0)(MIRRORED)(k) := d.msb
    line(0)(MAGNITUDE)(k) := d.abs.resize(23)
  }

  val fastest = new Area {
    val m = line(1)(MAGNITUDE)
    line(1)(FAST) := Mux(m(1) > m(0), Mux(m(2) > m(1), U(2), U(1)), Mux(m(2) > m(0), U(2), U(0)))
  }

  val ordered = new Area {
    val fast = line(2)(FAST)
    val eye = for (k <- 0 to 2) yield RayAxes.mirroredEye(c, line(2)(MIRRORED), io.eye, k)
    line(2)(MAJOR) := RayAxes.ordered(fast, line(2)(MAGNITUDE), 0)
    for (i <- 0 to 1) line(2)(MINOR)(i) := RayAxes.ordered(fast, line(2)(MAGNITUDE), i + 1)
    for (k <- 0 to 2) line(2)(FROM)(k) := RayAxes.ordered(fast, eye, k)
  }

  val normalise = new Area {
    val half = !line(3)(MAJOR).msb
    val f = Mux(half, line(3)(MAJOR)(20 downto 1), line(3)(MAJOR)(21 downto 2))
    line(3)(INDEX) := f(19 downto 12)
    line(3)(FRACTION) := f(11 downto 0)
    for (i <- 0 to 1) {
      val minor = line(3)(MINOR)(i)
      line(3)(SCALED)(i) := Mux(half, minor(21 downto 6), minor(22 downto 7))
    }
  }

  val reciprocal = new Area {
    val lines = Mem(
      Bits(32 bits),
      (0 until 256).map(i => B(ReciprocalTable.base(i).toLong << 13 | ReciprocalTable.slope(i), 32 bits))
    )
    lines.addAttribute("ram_style", "block") // small enough that tools would make five levels of logic of it
    val word = lines.readSync(line(3)(INDEX), enable) // at node 4
    val correction = Multiplier16(tech, signedA = false, signedB = false, add = true)
    correction.io.enable := enable
    correction.io.a := word(12 downto 0).resized
    correction.io.b := line(4)(FRACTION).asBits.resized
    correction.io.addend := word(31 downto 13) ## B(0, 13 bits)
    val r = correction.io.product(31 downto 16) // at node 6
  }

  for (i <- 0 to 1) {
    val product = Multiplier16(tech, signedA = false, signedB = false)
    product.io.enable := enable
    product.io.a := line(6)(SCALED)(i).asBits
    product.io.b := reciprocal.r
    val quotient = line(8)(SCALED)(i) - product.io.product(31 downto 17).asUInt
    line(8)(SLOPE)(i) := Mux(quotient.msb, U(0x7fff, 15 bits), quotient(14 downto 0)) >> 15 - c.slopeBits
  }

  val entry = new Area {
    val from = line(11)(FROM)
    val behind = line(9)(FROM)(0)(c.eyeBits - 1 downto 0)
    val after = Vec(Bool(), 2) // whether the axis comes after the fast one
    after(0) := line(11)(FAST) =/= 2
    after(1) := line(11)(FAST) === 0
    for (i <- 0 to 1) {
      val back = Multiplier16(tech, signedA = false, signedB = false)
      back.io.enable := enable
      back.io.a := line(9)(SLOPE)(i).asBits.resized
      back.io.b := behind.asBits.resized
      val low = after(i) && line(11)(SLOPE)(i) =/= 0
      line(11)(LOW)(i) := low
      line(11)(AT)(i) := (from(i + 1) ## B(0, c.slopeBits bits)).asSInt -
        (back.io.product(c.fractionBits downto 0).asUInt + low.asUInt).resize(c.fractionBits + 2).asSInt
    }
    val steep = Vec((0 to 1).map(i => line(11)(SLOPE)(i)(c.slopeBits - 1 downto c.slopeBits - 3)))
    val slabs = Vec(c.slabs.map(n => U(n, 7 bits)))(steep(1) @@ steep(0))
    line(11)(END) := (from(0) >> c.eyeBits).resize(c.endBits) + slabs.resize(c.endBits).asSInt
  }

  line.nodes.last.driveTo(io.down) { (payload, node) =>
    payload.ray.pixel := node(RAY).pixel
    payload.ray.pick := node(RAY).pick
    payload.ray.mirrored := node(MIRRORED)
    payload.ray.fast := node(FAST)
    payload.ray.slopes := node(SLOPE)
    payload.ray.low := node(LOW)
    payload.place.plane := node(FROM)(0) >> c.eyeBits
    payload.place.at := node(AT)
    for (i <- 0 to 1)
      payload.place.past(i) := (node(AT)(i) >> c.fractionBits) =/= (node(FROM)(i + 1) >> c.eyeBits)
    payload.end := node(END)
  }
  line.build()
}
