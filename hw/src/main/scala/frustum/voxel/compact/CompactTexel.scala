package frustum.voxel.compact

import frustum.arithmetic.WideMultiplier
import frustum.contract.voxel.{BlockTable, VoxelConfig}
import frustum.device.Tech
import frustum.voxel.march.{FaceHit, RayAxes, TexelHit}
import spinal.core._
import spinal.lib._

/** What [[FaceTexel]] does, a hit at a time, with one multiplier: 9 clocks where the border of the fast axis was met, 17 elsewhere, 1
  * for a ray that ends without a face. The model is the same.
  */
case class CompactTexel(c: VoxelConfig, slots: Int, tech: Tech) extends Component {
  val io = new Bundle {
    val up = slave(Stream(FaceHit(c, slots)))
    val down = master(Stream(TexelHit(c, slots)))
    val axis = out UInt (2 bits) // of the eye, which comes a clock later
    val eye = in SInt (c.blockBits + c.eyeBits bits)
  }
  private val shift = c.fractionBits
  private val topBits =
    c.slopeBits + 5 // of what is divided, in units of a sixteenth of the divisor's lowest digit

  val hit = Reg(FaceHit(c, slots))
  val within = Reg(Vec(
    SInt(shift + 2 bits),
    2
  )) // positions from the block's corner; the way to the border, and along it
  val own = Reg(UInt(c.slopeBits bits))
  val other = Reg(UInt(c.slopeBits bits))
  val clock = RegInit(U(0, 5 bits)) // 0 idle; 1 to 8 division; 9 to 15 distance; 16 done
  val Divide = 1
  val Away = 9
  val Done = 16

  val take = new Area {
    val second = io.up.entry === 2 // the border is the second other axis'
    val from = Vec((0 to 1).map { i =>
      val corner = (io.up.block(i + 1)(1 downto 0) ## B(0, shift bits)).asSInt
      (io.up.at(i) + io.up.ray.low(i).asUInt.resize(c.blockBits + shift).asSInt).resize(shift + 2) - corner
    })
    io.up.ready := clock === 0 || clock === Done && io.down.ready
    when(io.up.ready)(clock := 0)
    when(io.up.fire) {
      hit := io.up.payload
      within(0) := Mux(second, from(1), from(0))
      within(1) := Mux(second, from(0), from(1))
      own := Mux(second, io.up.ray.slopes(1), io.up.ray.slopes(0))
      other := Mux(second, io.up.ray.slopes(0), io.up.ray.slopes(1))
      clock := Mux(io.up.face, Mux(io.up.entry === 0, U(Away, 5 bits), U(Divide, 5 bits)), U(Done, 5 bits))
    }
    when(clock =/= 0 && clock =/= Done)(clock := clock + 1)
  }

  val multiplier = WideMultiplier(tech, shift + 2)
  val product = multiplier.io.product

  /** Sides of the dividends: run along the fast axis; what is before plus what is gained across. Then four digits of each quotient. */
  val divide = new Area {
    val across = Reg(UInt(shift + 1 + c.slopeBits bits))
    val along = Reg(UInt(topBits bits))
    val low = c.fractionBits - 4
    val digits = Vec(Reg(Bits(4 bits)), 2) // along, across
    when(clock === 1)(within(0) := -within(0))
    when(clock === 3)(across := product.asUInt.resized)
    when(clock === 4) {
      across := (across + product.asUInt.resize(across.getWidth))
      along := (within(0).asUInt >> c.eyeBits - 4).resized
    }
    private def less(rest: UInt) = rest.resize(topBits + 1) - (own << 3).resize(topBits + 1)
    private def rest(was: UInt, less: UInt) =
      (Mux(less.msb, was.resize(topBits), less.resize(topBits)) << 1).resize(topBits)
    val top = (across >> low).resize(topBits)
    val lessA = less(along)
    val lessB = less(top)
    when(clock >= 5 && clock <= 8) {
      along := rest(along, lessA)
      across := (rest(top, lessB) ## B(0, low bits)).asUInt.resized
      digits(0) := digits(0)(2 downto 0) ## !lessA.msb
      digits(1) := digits(1)(2 downto 0) ## !lessB.msb
    }
  }

  /** Texels within the block in the ray's order, mirrored. */
  val texel = Vec(UInt(4 bits), 3)
  val straight = within.map { w =>
    val sixteenth = w(shift downto shift - 4).asUInt
    Mux(sixteenth.msb, U(15, 4 bits), sixteenth(3 downto 0))
  }
  texel(0) := Mux(hit.entry === 0, U(0), divide.digits(0).asUInt)
  texel(1) := hit.entry.mux(0 -> straight(0), 1 -> U(0), default -> divide.digits(1).asUInt)
  texel(2) := hit.entry.mux(0 -> straight(1), 1 -> divide.digits(1).asUInt, default -> U(0))

  /** Squares of the ways from the eye's texel along the axes, one after the other. */
  val distance = new Area {
    val step = clock - Away // the eye is asked for at 0 to 2, the square at 2 to 4, it is there at 4 to 6
    private def axis(i: UInt) = { val sum = hit.ray.fast +^ i; Mux(sum >= 3, sum - 3, sum).resize(2) }
    io.axis := axis(step(1 downto 0))
    val i = (step - 1)(1 downto 0)
    val k = RegNext(io.axis)
    val size = k.mux((0 to 2).map(n =>
      n -> S(c.size.axes(n) << c.eyeBits, c.blockBits + c.eyeBits bits)
    ) :+ (default -> S(0, c.blockBits + c.eyeBits bits)): _*)
    val from = Mux(hit.ray.mirrored(k), size - io.eye, io.eye) >> c.eyeBits - 4
    val block = i.mux(0 -> hit.block(0), 1 -> hit.block(1), default -> hit.block(2))
    val t = i.mux(0 -> texel(0), 1 -> texel(1), default -> texel(2))
    val away = Reg(SInt(c.blockBits + 5 bits))
    val far = Reg(UInt(TexelHit.FarBits bits))
    away := (block @@ t).resize(c.blockBits + 5).asSInt - from.resize(c.blockBits + 5)
    val length = away.abs.resize(c.blockBits + 5)
    when(step === 4)(far := product.asUInt.resized)
    when(step === 5 || step === 6)(far := far + product.asUInt.resize(TexelHit.FarBits))
  }

  multiplier.io.a := clock.mux(
    1 -> within(1),
    2 -> within(0),
    default -> distance.length.resize(shift + 2).asSInt
  )
  multiplier.io.b := clock.mux(
    1 -> own.resize(16),
    2 -> other.resize(16),
    default -> distance.length.resize(16)
  )

  val result = new Area {
    val ray = hit.ray
    val inside = (0 to 2).map { k =>
      val t = RayAxes.xyz(ray.fast, texel, k)
      Mux(ray.mirrored(k), ~t, t)
    }
    val sum = ray.fast.resize(3) + hit.entry
    val side = Mux(sum >= 3, sum - 3, sum).resize(2)
    val out = io.down.payload
    io.down.valid := clock === Done
    out.slot := hit.slot
    out.last := hit.last
    out.id := hit.id
    out.pixel := ray.pixel
    out.pick := ray.pick
    out.face := side @@ ray.mirrored(side)
    for (k <- 0 to 2) {
      val block = RayAxes.xyz(ray.fast, hit.block, k)
      out.block(k) := Mux(ray.mirrored(k), U(c.size.axes(k) - 1, c.size.logs.max bits) - block, block)
    }
    val (u, v) = TexelHit.uv(out.face, inside)
    out.u := u
    out.v := v
    out.far := distance.far
    out.shown := hit.face && out.far <= c.farSquared
  }
}
