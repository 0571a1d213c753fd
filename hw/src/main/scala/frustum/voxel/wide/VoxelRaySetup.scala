package frustum.voxel.wide

import frustum.arithmetic.{LockstepPipeline, Multiplier16, ReciprocalUnit}
import frustum.contract.voxel.VoxelConfig
import frustum.device.Tech
import frustum.voxel.march.{PixelRay, RayAxes, RayEntry, RaySlope, RayStart}
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Start of a ray from its direction, one per cycle, latency [[VoxelRaySetup.Latency]] cycles, 5 multipliers.
  *
  *   1. `fast` is the axis of the greatest component, the first of equal ones
  *   1. slopes of the two others, [[RaySlope]]
  *   1. the ray is taken back from the eye to the border of blocks behind it, [[RayEntry]]
  *
  * The model is `frustum.model.voxel.wide.VoxelRaySetup`.
  */
case class VoxelRaySetup(config: VoxelConfig, tech: Tech = Tech.Generic) extends Component {
  import VoxelRaySetup._
  val io = new Bundle {
    val eye = in Vec (SInt(config.blockBits + config.eyeBits bits), 3)
    val up = slave(Stream(PixelRay(config)))
    val down = master(Stream(RayStart(config)))
  }
  val line = new LockstepPipeline(Latency)
  val enable = line.enable

  val RAY = Payload(PixelRay(config))
  val MIRRORED = Payload(Bits(3 bits))
  val MAGNITUDE = Payload(Vec(UInt(RaySlope.MagnitudeBits bits), 3))
  val FAST = Payload(UInt(2 bits))
  val MAJOR = Payload(UInt(RaySlope.MagnitudeBits bits))
  val MINOR = Payload(Vec(UInt(RaySlope.MagnitudeBits bits), 2))
  val SCALED = Payload(Vec(UInt(16 bits), 2))
  val SLOPE = Payload(Vec(UInt(config.slopeBits bits), 2))
  val FROM = Payload(Vec(SInt(config.blockBits + config.eyeBits bits), 3)) // the eye, mirrored, fast axis first
  val AT = Payload(Vec(SInt(config.blockBits + config.fractionBits bits), 2))
  val LOW = Payload(Bits(2 bits))
  val END = Payload(SInt(config.endBits bits))

  line(MagnitudeNode).driveFrom(io.up)((node, payload) => node(RAY) := payload)
  for (k <- 0 to 2) {
    val component = io.up.direction.axes(k)
    line(MagnitudeNode)(MIRRORED)(k) := component.msb
    line(MagnitudeNode)(MAGNITUDE)(k) := component.abs.resize(RaySlope.MagnitudeBits)
  }

  val fastest = new Area {
    val m = line(FastNode)(MAGNITUDE)
    line(FastNode)(FAST) := Mux(m(1) > m(0), Mux(m(2) > m(1), U(2), U(1)), Mux(m(2) > m(0), U(2), U(0)))
  }

  val ordered = new Area {
    val node = line(OrderNode)
    val fast = node(FAST)
    val eye = for (k <- 0 to 2) yield RayAxes.mirroredEye(config, node(MIRRORED), io.eye, k)
    node(MAJOR) := RayAxes.ordered(fast, node(MAGNITUDE), 0)
    for (i <- 0 to 1) node(MINOR)(i) := RayAxes.ordered(fast, node(MAGNITUDE), i + 1)
    for (i <- 0 to 2) node(FROM)(i) := RayAxes.ordered(fast, eye, i)
  }

  val reciprocal = ReciprocalUnit(tech)
  reciprocal.io.enable := enable
  reciprocal.io.f := RaySlope.mantissa(line(ScaleNode)(MAJOR))

  val slopes = for (i <- 0 to 1) yield new Area {
    line(ScaleNode)(SCALED)(i) := RaySlope.scaled(line(ScaleNode)(MINOR)(i), line(ScaleNode)(MAJOR))
    val product = Multiplier16(tech, signedA = false, signedB = false)
    product.io.enable := enable
    product.io.a := line(ReciprocalNode)(SCALED)(i).asBits
    product.io.b := reciprocal.io.r
    line(SlopeNode)(SLOPE)(i) := RaySlope(config, line(SlopeNode)(SCALED)(i), product.io.product)
  }

  val entry = new Area {
    val node = line(EntryNode)
    val behind = RayEntry.behind(config, line(BackNode)(FROM)(0))
    for (i <- 0 to 1) {
      val back = Multiplier16(tech, signedA = false, signedB = false)
      back.io.enable := enable
      back.io.a := line(BackNode)(SLOPE)(i).asBits.resized
      back.io.b := behind.asBits.resized
      val low = RayEntry.low(node(FAST), node(SLOPE)(i), i)
      node(LOW)(i) := low
      node(AT)(i) := RayEntry.at(config, node(FROM)(i + 1), back.io.product, low)
    }
    node(END) := RayEntry.end(config, RayEntry.plane(config, node(FROM)(0)), node(SLOPE))
  }

  line(Latency).driveTo(io.down) { (payload, node) =>
    payload.ray.pixel := node(RAY).pixel
    payload.ray.pick := node(RAY).pick
    payload.ray.mirrored := node(MIRRORED)
    payload.ray.fast := node(FAST)
    payload.ray.slopes := node(SLOPE)
    payload.ray.low := node(LOW)
    payload.place.plane := RayEntry.plane(config, node(FROM)(0))
    payload.place.at := node(AT)
    for (i <- 0 to 1) payload.place.past(i) := RayEntry.past(config, node(AT)(i), node(FROM)(i + 1))
    payload.end := node(END)
  }
  line.build()
}

object VoxelRaySetup {
  // Nodes at which something is made, each a cycle behind what it is made of, or the cycles of a unit between them.
  private val MagnitudeNode = 0
  private val FastNode = MagnitudeNode + 1
  private val OrderNode = FastNode + 1
  private val ScaleNode = OrderNode + 1
  private val ReciprocalNode = ScaleNode + ReciprocalUnit.Latency
  private val SlopeNode = ReciprocalNode + Multiplier16.Latency
  private val BackNode = SlopeNode + 1
  private val EntryNode = BackNode + Multiplier16.Latency
  val Latency: Int = EntryNode + 1
}
