package frustum.voxel.wide

import frustum.arithmetic.LockstepPipeline
import frustum.contract.voxel.{BlockTable, FaceLight, VoxelConfig, VoxelTextures}
import frustum.voxel.march.{FaceLevel, Fog, LayerBlend, PointedAt, TexelHit, VoxelColor}
import frustum.voxel.world.VoxelTables
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Colours of faces, gathered front to back for each ray until nothing behind is visible: one layer per cycle, latency
  * [[LayerComposite.Latency]] cycles. The remaining transparency of a ray shows sky. The model is
  * `frustum.model.voxel.wide.LayerComposite`.
  *
  * @param slots rays at one time, each with its own layers
  */
case class LayerComposite(config: VoxelConfig, kinds: BlockTable, textures: VoxelTextures, slots: Int)
    extends Component {
  import LayerComposite._
  val io = new Bundle {
    val pointedAt = in(PointedAt(config))
    val up = slave(Flow(TexelHit(config, slots)))
    val down = master(Flow(VoxelColor(config)))
  }
  private val line = new LockstepPipeline(Latency)
  private val sky = config.skyChannels.map(U(_, 8 bits))

  val HIT = Payload(TexelHit(config, slots))
  val CHOSEN = Payload(Bool())
  val BEYOND = Payload(UInt(TexelHit.FarBits bits))
  val FOG = Payload(UInt(Fog.WeightBits bits))
  val OPACITY = Payload(UInt(5 bits)) // in 1/16
  val LIT = Payload(Vec(UInt(8 bits), 3))
  val SHOWN = Payload(Vec(UInt(8 bits), 3))
  val VEIL = Payload(Vec(SInt(18 bits), 3)) // what fog adds, times 256
  val COLOR = Payload(Vec(UInt(8 bits), 3))
  val WEIGHT = Payload(UInt(8 bits))
  val LIGHT = Payload(Vec(UInt(16 bits), 3))
  val TOTAL = Payload(Vec(UInt(16 bits), 3))
  val PIXEL = Payload(Vec(UInt(8 bits), 3))

  line(HitNode).valid := io.up.valid
  line(HitNode)(HIT) := io.up.payload

  val tables = VoxelTables(kinds, textures)
  tables.io.id := line(HitNode)(HIT).id
  tables.io.face := line(HitNode)(HIT).face
  tables.io.u := line(HitNode)(HIT).u
  tables.io.v := line(HitNode)(HIT).v

  val distance = new Area {
    val node = line(BeyondNode)
    node(BEYOND) := Fog.beyond(config, node(HIT).far)
    node(CHOSEN) := io.pointedAt.is(node(HIT))
    // Shown faces are within the view: the product has at most 25 bits. What is out of view is not shown.
    line(FogNode)(FOG) := Fog.weight(config, line(FogNode)(BEYOND) * U(config.fogStep))
  }

  val lit = new Area {
    val node = line(LitNode)
    val rgba = tables.io.rgba
    val level = FaceLevel.of(node(HIT).face)
    node(OPACITY) := LayerBlend.opacity(node(HIT).shown, rgba)
    for ((at, i) <- Seq(12, 8, 4).zipWithIndex) {
      val table = Vec(FaceLevel.lit.map(U(_, 8 bits)))
      node(LIT)(i) := table(level @@ rgba(at, 4 bits).asUInt)
    }
  }

  val highlight = new Area {
    val node = line(ShownNode)
    for (i <- 0 to 2) {
      val scaled = (node(LIT)(i) * U(FaceLight.HighlightScale)) >> 16
      node(SHOWN)(i) := Mux(node(CHOSEN), scaled.resize(8) + FaceLight.HighlightGrey, node(LIT)(i))
    }
  }

  val fog = new Area {
    for (i <- 0 to 2) {
      val (veil, color) = (line(VeilNode), line(ColorNode))
      veil(VEIL)(i) := (Fog.difference(sky(i), veil(SHOWN)(i)) * (False ## veil(FOG)).asSInt).resize(18)
      val faded = (False ## color(SHOWN)(i)).asSInt + (color(VEIL)(i) >> 8).resize(9)
      color(COLOR)(i) := Mux(color(HIT).shown, faded(7 downto 0).asUInt, sky(i))
    }
  }

  /** The remaining transparency of each ray, of 255. A ray's last layer leaves its slot ready for another ray. */
  val clear = new Area {
    val node = line(WeightNode)
    val slot = node(HIT).slot
    val left = Vec.fill(slots)(RegInit(U(255, 8 bits)))
    val weight = (left(slot) * node(OPACITY) >> 4).resize(8)
    node(WEIGHT) := weight
    when(node.isValid)(left(slot) := Mux(node(HIT).last, U(255, 8 bits), left(slot) - weight))
  }

  for (i <- 0 to 2) line(LightNode)(LIGHT)(i) := line(LightNode)(COLOR)(i) * line(LightNode)(WEIGHT)

  val gather = new Area {
    val node = line(TotalNode)
    val slot = node(HIT).slot
    for (i <- 0 to 2) {
      val sums = Vec.fill(slots)(RegInit(U(0, 16 bits)))
      val sum = sums(slot) + node(LIGHT)(i)
      node(TOTAL)(i) := sum
      when(node.isValid)(sums(slot) := Mux(node(HIT).last, U(0, 16 bits), sum))
    }
  }

  val result = new Area {
    val node = line(Latency)
    for (i <- 0 to 2) line(PixelNode)(PIXEL)(i) := LayerBlend.channel(line(PixelNode)(TOTAL)(i))
    io.down.valid := node.isValid && node(HIT).last && !node(HIT).pick
    io.down.pixel := node(HIT).pixel
    io.down.rgb := node(PIXEL)
  }
  line.build()
}

object LayerComposite {
  // Nodes at which something is made, each a cycle behind what it is made of, or the tables' cycles behind the hit.
  private val HitNode = 0
  private val BeyondNode = HitNode + 1
  private val FogNode = BeyondNode + 1
  private val LitNode = HitNode + VoxelTables.Latency
  private val ShownNode = LitNode + 1
  private val VeilNode = ShownNode + 1
  private val ColorNode = VeilNode + 1
  private val WeightNode = ColorNode + 1
  private val LightNode = WeightNode + 1
  private val TotalNode = LightNode + 1
  private val PixelNode = TotalNode + 1
  val Latency: Int = PixelNode + 1
}
