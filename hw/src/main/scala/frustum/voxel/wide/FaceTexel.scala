package frustum.voxel.wide

import frustum.arithmetic.LockstepPipeline
import frustum.contract.voxel.VoxelConfig
import frustum.voxel.march.{FaceHit, RayAxes, TexelHit}
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Texels of faces, one a clock, latency 10 clocks, 5 multiplications.
  *
  * On a border of the fast axis the position tells the texel. On another axis' border the ray is where it was at the last border of the fast axis,
  * plus run / slope along the fast axis and run * otherSlope / slope along the third, run being the way to the border: four digits of
  * two divisions, exact. The model is `frustum.model.voxel.wide.FaceTexel`.
  */
case class FaceTexel(c: VoxelConfig, slots: Int) extends Component {
  val io = new Bundle {
    val eye = in Vec (SInt(c.blockBits + c.eyeBits bits), 3)
    val up = slave(Flow(FaceHit(c, slots)))
    val down = master(Flow(TexelHit(c, slots)))
  }
  private val shift = c.fractionBits
  private val line = new LockstepPipeline(10)

  val HIT = Payload(FaceHit(c, slots))
  val WITHIN = Payload(Vec(SInt(shift + 2 bits), 2)) // positions from the block's corner
  val RUN = Payload(UInt(shift + 1 bits))
  val SIDE = Payload(SInt(shift + 2 bits))
  val OWN = Payload(UInt(c.slopeBits bits))
  val OTHER = Payload(UInt(c.slopeBits bits))
  val BEFORE = Payload(SInt(shift + 2 + c.slopeBits + 1 bits))
  val DURING = Payload(UInt(shift + 1 + c.slopeBits bits))
  val ALONG = Seq.fill(4)(Payload(UInt(shift + 1 bits))) // rests of the divisions before digit k
  val ACROSS = Seq.fill(4)(Payload(UInt(shift + 1 + c.slopeBits bits)))
  val DIGIT = Seq.fill(4)(Payload(Bits(2 bits)))
  val TEXEL = Payload(Vec(UInt(4 bits), 3)) // fast axis first, mirrored
  val INSIDE = Payload(Vec(UInt(4 bits), 3)) // x, y, z
  val BLOCK = Payload(Vec(UInt(c.size.logs.max bits), 3)) // x, y, z
  val AWAY = Payload(Vec(SInt(c.blockBits + 5 bits), 3))
  val SQUARE = Payload(Vec(UInt(TexelHit.FarBits bits), 3))
  val FACE = Payload(UInt(3 bits))

  line(0).valid := io.up.valid
  line(0)(HIT) := io.up.payload
  for (i <- 0 to 1) {
    val corner = (io.up.block(i + 1) ## B(0, shift bits)).asUInt.resize(c.blockBits + shift).asSInt
    line(0)(WITHIN)(i) := (io.up.at(i) + io.up.ray.low(i).asUInt.resize(c.blockBits + shift).asSInt - corner)
      .resize(shift + 2)
  }

  val operands = new Area {
    val node = line(1)
    val second = node(HIT).entry === 2 // the border is the second other axis'
    node(RUN) := (-Mux(second, node(WITHIN)(1), node(WITHIN)(0))).asUInt.resize(shift + 1)
    node(SIDE) := Mux(second, node(WITHIN)(0), node(WITHIN)(1))
    node(OWN) := Mux(second, node(HIT).ray.slopes(1), node(HIT).ray.slopes(0))
    node(OTHER) := Mux(second, node(HIT).ray.slopes(0), node(HIT).ray.slopes(1))
  }
  val products = new Area {
    val node = line(2)
    node(BEFORE) := node(SIDE) * (False ## node(OWN)).asSInt
    node(DURING) := node(RUN) * node(OTHER)
  }

  val dividends = new Area {
    val node = line(3)
    val during = node(DURING).resize(shift + 3 + c.slopeBits).asSInt
    node(ALONG(3)) := node(RUN)
    node(ACROSS(3)) := (node(BEFORE) + during).asUInt.resized
  }

  /** A digit of both quotients at each of four nodes: subtract a sixteenth of the divisor times 2^k where that goes. */
  val division = for (k <- 3 to 0 by -1) yield new Area {
    val node = line(6 - k)
    for (
      (i, rest, next, sixteenth) <- Seq(
        (0, ALONG(k), ALONG.lift(k - 1), c.eyeBits - 4),
        (1, ACROSS(k), ACROSS.lift(k - 1), c.fractionBits - 4)
      )
    ) {
      val width = node(rest).getWidth + 1
      val less = node(rest).resize(width) - (node(OWN) << sixteenth + k).resize(width)
      node(DIGIT(k))(i) := !less.msb
      next.foreach(n => node(n) := Mux(less.msb, node(rest), less.resize(node(rest).getWidth)))
    }
  }

  val texel = new Area {
    val node = line(7)
    val straight = Vec((0 to 1).map { i =>
      val sixteenth = node(WITHIN)(i)(shift downto shift - 4).asUInt
      Mux(sixteenth.msb, U(15, 4 bits), sixteenth(3 downto 0))
    })
    val Seq(along, across) = (0 to 1).map(i => Cat((0 to 3).map(k => node(DIGIT(k))(i))).asUInt)
    val entry = node(HIT).entry
    node(TEXEL)(0) := Mux(entry === 0, U(0), along)
    node(TEXEL)(1) := entry.mux(0 -> straight(0), 1 -> U(0), default -> across)
    node(TEXEL)(2) := entry.mux(0 -> straight(1), 1 -> across, default -> U(0))
  }

  val unmirror = new Area {
    val node = line(8)
    val ray = node(HIT).ray
    for (k <- 0 to 2) {
      val t = RayAxes.xyz(ray.fast, node(TEXEL), k)
      val block = RayAxes.xyz(ray.fast, node(HIT).block, k)
      val eye = RayAxes.mirroredEye(c, ray.mirrored, io.eye, k)
      val from = (eye >> c.eyeBits - 4).resize(c.blockBits + 5)
      node(INSIDE)(k) := Mux(ray.mirrored(k), ~t, t)
      node(BLOCK)(k) := Mux(ray.mirrored(k), U((c.size.axes(k) - 1), c.size.logs.max bits) - block, block)
      node(AWAY)(k) := (block @@ t).resize(c.blockBits + 5).asSInt - from
    }
    val sum = ray.fast.resize(3) + node(HIT).entry
    val side = Mux(sum >= 3, sum - 3, sum).resize(2)
    node(FACE) := side @@ ray.mirrored(side)
  }
  val squares = new Area {
    val node = line(9)
    for (k <- 0 to 2) node(SQUARE)(k) := (node(AWAY)(k) * node(AWAY)(k)).asUInt.resize(TexelHit.FarBits)
  }

  val result = new Area {
    val node = line.nodes.last
    val in = node(HIT)
    val (u, v) = TexelHit.uv(node(FACE), node(INSIDE))
    val out = io.down.payload
    io.down.valid := node.isValid
    out.slot := in.slot
    out.last := in.last
    out.id := in.id
    out.pixel := in.ray.pixel
    out.pick := in.ray.pick
    out.face := node(FACE)
    out.block := node(BLOCK)
    out.u := u
    out.v := v
    out.far := node(SQUARE).reduce(_ + _)
    out.shown := in.face && out.far <= c.farSquared
  }
  line.build()
}
