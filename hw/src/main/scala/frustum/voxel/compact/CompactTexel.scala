package frustum.voxel.compact

import frustum.arithmetic.{Multiplier16, WideMultiplier}
import frustum.contract.voxel.VoxelConfig
import frustum.device.Tech
import frustum.voxel.march.{CameraMemory, FaceHit, FacePlace, QuotientDigit, RayAxes, TexelHit}
import spinal.core._
import spinal.lib._

/** What [[FaceTexel]] does, a hit at a time, with one multiplier: 9 cycles on a border of the fast axis, 17 elsewhere,
  * 1 for a ray that ends without a face. The model is the same.
  */
case class CompactTexel(config: VoxelConfig, slots: Int, tech: Tech = Tech.Generic) extends Component {
  import CompactTexel._
  val io = new Bundle {
    val up = slave(Stream(FaceHit(config, slots)))
    val down = master(Stream(TexelHit(config, slots)))
    val axis = out UInt (2 bits) // of the eye, which comes `CameraMemory.Latency` later
    val eye = in SInt (config.blockBits + config.eyeBits bits)
  }
  private val shift = config.fractionBits
  private val withinBits = FacePlace.withinBits(config)

  val hit = Reg(FaceHit(config, slots))
  val within = Reg(Vec(SInt(withinBits bits), 2)) // that of the border's axis, if it is not the fast one, first
  val own = Reg(UInt(config.slopeBits bits))
  val other = Reg(UInt(config.slopeBits bits))
  val step = RegInit(U(Idle, 5 bits))

  val take = new Area {
    val entry = io.up.entry
    val from = (0 to 1).map(FacePlace.within(config, io.up.payload, _))
    val first = Mux(io.up.face, Mux(entry === 0, U(AskEye, 5 bits), U(MultiplySide, 5 bits)), U(Done, 5 bits))
    io.up.ready := step === Idle || step === Done && io.down.ready
    when(io.up.ready)(step := Idle)
    when(io.up.fire) {
      hit := io.up.payload
      within(0) := FacePlace.own(entry, from)
      within(1) := FacePlace.other(entry, from)
      own := FacePlace.own(entry, io.up.ray.slopes)
      other := FacePlace.other(entry, io.up.ray.slopes)
      step := first
    }
    when(step =/= Idle && step =/= Done)(step := step + 1)
  }

  val multiplier = WideMultiplier(tech, withinBits)
  val product = multiplier.io.product

  /** The dividends, then their digits, the highest first: the divisor stays, and what is left is doubled. */
  val divide = new Area {
    val low = config.fractionBits - FacePlace.Digits // bits of the dividend `across` below its unit
    val across = Reg(UInt(shift + 1 + config.slopeBits bits))
    val along = Reg(UInt(config.slopeBits + FacePlace.Digits + 1 bits)) // in sixteenths of the divisor's unit
    val digits = Vec(Reg(Bits(FacePlace.Digits bits)), 2) // along, across
    when(step === MultiplySide)(within(0) := -within(0)) // from now on the run
    when(step === SideProduct)(across := product.asUInt.resized)
    when(step === RunProduct) {
      across := across + product.asUInt.resize(across.getWidth)
      along := (within(0).asUInt >> config.eyeBits - FacePlace.Digits).resized
    }
    val top = (across >> low).resize(along.getWidth)
    val Seq(ofAlong, ofAcross) = Seq(along, top).map(new QuotientDigit(_, own << FacePlace.Digits - 1))
    when(step >= Divide && step <= LastDigit) {
      along := (ofAlong.left << 1).resized
      across := (ofAcross.left ## B(0, low + 1 bits)).asUInt.resized
      digits(0) := digits(0)(FacePlace.Digits - 2 downto 0) ## ofAlong.digit
      digits(1) := digits(1)(FacePlace.Digits - 2 downto 0) ## ofAcross.digit
    }
  }
  val straight = within.map(FacePlace.straight(config, _))
  val texel = FacePlace.texel(hit.entry, straight, divide.digits(0).asUInt, divide.digits(1).asUInt)

  /** Squares of the ways from the eye's texel along the axes, one after the other, from `AskEye` on. */
  val distance = new Area {
    private def ith(from: Int) = (step - from)(1 downto 0) // operands in the ray's order
    val i = ith(AskEye + CameraMemory.Latency)
    val away = Reg(SInt(config.blockBits + 5 bits))
    val far = Reg(UInt(TexelHit.FarBits bits))
    io.axis := RayAxes.number(hit.ray.fast, ith(AskEye))
    val eye = RayAxes.mirroredEye(config, hit.ray.mirrored, io.eye, Delay(io.axis, CameraMemory.Latency))
    val block = i.mux(0 -> hit.block(0), 1 -> hit.block(1), default -> hit.block(2))
    val t = i.mux(0 -> texel(0), 1 -> texel(1), default -> texel(2))
    away := FacePlace.away(config, block, t, eye)
    val length = away.abs.resize(config.blockBits + 5)
    when(step === Square)(far := product.asUInt.resized)
    when(step === Square + 1 || step === Square + 2)(far := far + product.asUInt.resize(TexelHit.FarBits))
  }

  multiplier.io.a := step.mux(
    MultiplySide -> within(1),
    MultiplyRun -> within(0),
    default -> distance.length.resize(withinBits).asSInt
  )
  multiplier.io.b := step.mux(
    MultiplySide -> own.resize(16),
    MultiplyRun -> other.resize(16),
    default -> distance.length.resize(16)
  )

  val result = new Area {
    val ray = hit.ray
    val out = io.down.payload
    val face = FacePlace.face(hit)
    val (u, v) = FacePlace.uv(face, (0 to 2).map(k => RayAxes.texel(ray.mirrored, RayAxes.xyz(ray.fast, texel, k), k)))
    io.down.valid := step === Done
    out.follow(hit, distance.far)
    out.face := face
    for (k <- 0 to 2) out.block(k) := RayAxes.block(config, ray.mirrored, RayAxes.xyz(ray.fast, hit.block, k), k)
    out.u := u
    out.v := v
  }
}

object CompactTexel {
  // Steps: at which operands are given to the multiplier, a product is taken, or something is requested.
  private val Idle = 0
  private val MultiplySide = 1
  private val MultiplyRun = MultiplySide + 1
  private val SideProduct = MultiplySide + Multiplier16.Latency
  private val RunProduct = MultiplyRun + Multiplier16.Latency
  private val Divide = RunProduct + 1
  private val LastDigit = Divide + FacePlace.Digits - 1
  private val AskEye = LastDigit + 1 // three axes in turn, as all that follows

  /** The eye comes, then the way from it, then its square. */
  private val Square = AskEye + CameraMemory.Latency + 1 + Multiplier16.Latency
  private val Done = Square + 3
}
