package frustum.voxel.wide

import frustum.arithmetic.LockstepPipeline
import frustum.contract.voxel.VoxelConfig
import frustum.voxel.march.{FaceHit, FacePlace, QuotientDigit, RayAxes, TexelHit}
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Texels of faces by [[FacePlace]], one per cycle, latency [[FaceTexel.Latency]] cycles, 5 multiplications. The model
  * is `frustum.model.voxel.wide.FaceTexel`.
  */
case class FaceTexel(config: VoxelConfig, slots: Int) extends Component {
  import FaceTexel._
  val io = new Bundle {
    val eye = in Vec (SInt(config.blockBits + config.eyeBits bits), 3)
    val up = slave(Flow(FaceHit(config, slots)))
    val down = master(Flow(TexelHit(config, slots)))
  }
  private val shift = config.fractionBits
  private val acrossBits = shift + 1 + config.slopeBits
  private val line = new LockstepPipeline(Latency)

  val HIT = Payload(FaceHit(config, slots))
  val WITHIN = Payload(Vec(SInt(FacePlace.withinBits(config) bits), 2))
  val RUN = Payload(UInt(shift + 1 bits))
  val SIDE = Payload(SInt(FacePlace.withinBits(config) bits))
  val OWN = Payload(UInt(config.slopeBits bits))
  val OTHER = Payload(UInt(config.slopeBits bits))
  val BEFORE = Payload(SInt(shift + 2 + config.slopeBits + 1 bits))
  val DURING = Payload(UInt(acrossBits bits))
  val ALONG = Seq.fill(FacePlace.Digits)(Payload(UInt(shift + 1 bits))) // rests of the divisions before digit k
  val ACROSS = Seq.fill(FacePlace.Digits)(Payload(UInt(acrossBits bits)))
  val DIGIT = Seq.fill(FacePlace.Digits)(Payload(Bits(2 bits)))
  val TEXEL = Payload(Vec(UInt(FacePlace.Digits bits), 3)) // fast axis first, mirrored
  val INSIDE = Payload(Vec(UInt(FacePlace.Digits bits), 3)) // x, y, z
  val BLOCK = Payload(Vec(UInt(config.size.logs.max bits), 3)) // x, y, z
  val AWAY = Payload(Vec(SInt(config.blockBits + 5 bits), 3))
  val SQUARE = Payload(Vec(UInt(TexelHit.FarBits bits), 3))
  val FACE = Payload(UInt(3 bits))

  line(WithinNode).valid := io.up.valid
  line(WithinNode)(HIT) := io.up.payload
  for (i <- 0 to 1) line(WithinNode)(WITHIN)(i) := FacePlace.within(config, io.up.payload, i)

  val operands = new Area {
    val node = line(OperandNode)
    val entry = node(HIT).entry
    node(RUN) := (-FacePlace.own(entry, node(WITHIN))).asUInt.resize(shift + 1)
    node(SIDE) := FacePlace.other(entry, node(WITHIN))
    node(OWN) := FacePlace.own(entry, node(HIT).ray.slopes)
    node(OTHER) := FacePlace.other(entry, node(HIT).ray.slopes)
  }
  val products = new Area {
    val node = line(ProductNode)
    node(BEFORE) := node(SIDE) * (False ## node(OWN)).asSInt
    node(DURING) := node(RUN) * node(OTHER)
  }

  val dividends = new Area {
    val node = line(DivideNode)
    val during = node(DURING).resize(acrossBits + 2).asSInt
    node(ALONG.last) := node(RUN)
    node(ACROSS.last) := (node(BEFORE) + during).asUInt.resized
  }

  /** A digit of both quotients at each node, the highest first. */
  val division = for (k <- FacePlace.Digits - 1 to 0 by -1) yield new Area {
    val node = line(TexelNode - 1 - k)
    for ((rests, one, i) <- Seq((ALONG, config.eyeBits, 0), (ACROSS, shift, 1))) {
      val quotient = new QuotientDigit(node(rests(k)), node(OWN) << one - FacePlace.Digits + k)
      node(DIGIT(k))(i) := quotient.digit
      rests.lift(k - 1).foreach(node(_) := quotient.left)
    }
  }

  val texel = new Area {
    val node = line(TexelNode)
    val straight = node(WITHIN).map(FacePlace.straight(config, _))
    val Seq(along, across) = (0 to 1).map(i => Cat(DIGIT.map(node(_)(i))).asUInt)
    node(TEXEL) := FacePlace.texel(node(HIT).entry, straight, along, across)
  }

  val unmirror = new Area {
    val node = line(UnmirrorNode)
    val ray = node(HIT).ray
    for (k <- 0 to 2) {
      val t = RayAxes.xyz(ray.fast, node(TEXEL), k)
      val block = RayAxes.xyz(ray.fast, node(HIT).block, k)
      node(INSIDE)(k) := RayAxes.texel(ray.mirrored, t, k)
      node(BLOCK)(k) := RayAxes.block(config, ray.mirrored, block, k)
      node(AWAY)(k) := FacePlace.away(config, block, t, RayAxes.mirroredEye(config, ray.mirrored, io.eye, k))
    }
    node(FACE) := FacePlace.face(node(HIT))
  }
  val squares = new Area {
    val node = line(SquareNode)
    for (k <- 0 to 2) node(SQUARE)(k) := (node(AWAY)(k) * node(AWAY)(k)).asUInt.resize(TexelHit.FarBits)
  }

  val result = new Area {
    val node = line(Latency)
    val (u, v) = FacePlace.uv(node(FACE), node(INSIDE))
    val out = io.down.payload
    io.down.valid := node.isValid
    out.follow(node(HIT), distance = node(SQUARE).reduce(_ + _))
    out.face := node(FACE)
    out.block := node(BLOCK)
    out.u := u
    out.v := v
  }
  line.build()
}

object FaceTexel {
  // Nodes at which something is made, each a cycle behind what it is made of; the division takes one for each digit.
  private val WithinNode = 0
  private val OperandNode = WithinNode + 1
  private val ProductNode = OperandNode + 1
  private val DivideNode = ProductNode + 1
  private val TexelNode = DivideNode + FacePlace.Digits
  private val UnmirrorNode = TexelNode + 1
  private val SquareNode = UnmirrorNode + 1
  val Latency: Int = SquareNode + 1
}
