package frustum.voxel.wide

import frustum.arithmetic.LockstepPipeline
import frustum.contract.voxel.{BlockTable, VoxelConfig, VoxelTextures}
import frustum.voxel.march.{PointedAt, TexelHit, VoxelColor}
import frustum.voxel.world.VoxelTables
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Colours of faces, gathered front to back for each ray until nothing behind shows: a layer a clock, latency 11 clocks.
  * What a ray does not hide is sky. The model is `frustum.model.voxel.wide.LayerComposite`.
  *
  * @param slots rays at one time, each with its own layers
  */
case class LayerComposite(c: VoxelConfig, kinds: BlockTable, textures: VoxelTextures, slots: Int)
    extends Component {
  val io = new Bundle {
    val pointedAt = in(PointedAt(c))
    val up = slave(Flow(TexelHit(c, slots)))
    val down = master(Flow(VoxelColor(c)))
  }
  private val line = new LockstepPipeline(11)
  private val sky = Seq(16, 8, 0).map(at => c.sky >> at & 255)

  val HIT = Payload(TexelHit(c, slots))
  val CHOSEN = Payload(Bool())
  val BEYOND = Payload(UInt(TexelHit.FarBits bits))
  val FOG = Payload(UInt(9 bits))
  val ALPHA = Payload(UInt(5 bits)) // of 16
  val LIT = Payload(Vec(UInt(8 bits), 3))
  val SHOWN = Payload(Vec(UInt(8 bits), 3))
  val VEIL = Payload(Vec(SInt(18 bits), 3))
  val COLOR = Payload(Vec(UInt(8 bits), 3))
  val WEIGHT = Payload(UInt(8 bits))
  val LIGHT = Payload(Vec(UInt(16 bits), 3))
  val TOTAL = Payload(Vec(UInt(16 bits), 3))
  val PIXEL = Payload(Vec(UInt(8 bits), 3))

  line(0).valid := io.up.valid
  line(0)(HIT) := io.up.payload

  val tables = VoxelTables(kinds, textures)
  tables.io.id := line(0)(HIT).id
  tables.io.face := line(0)(HIT).face
  tables.io.u := line(0)(HIT).u
  tables.io.v := line(0)(HIT).v
  private val rgba = tables.io.rgba // at node 3

  val distance = new Area {
    val hit = line(1)(HIT)
    line(1)(BEYOND) := Mux(hit.far > c.fogSquared, hit.far - c.fogSquared, U(0))
    // Shown faces are within the view: the product has at most 25 bits. What is out of view is not shown.
    val weight = line(2)(BEYOND)(TexelHit.FarBits - 1 downto 0) * U(c.fogStep)
    line(2)(FOG) := (if (c.fog) (weight >> 16).resize(9) else U(0, 9 bits))
    val at = io.pointedAt
    line(1)(CHOSEN) := at.valid && at.face === hit.face && at.block === hit.block
  }

  val lit = new Area {
    val node = line(3)
    val alpha = rgba(3 downto 0).asUInt
    node(ALPHA) := Mux(node(HIT).shown, alpha.resize(5) + alpha.msb.asUInt, U(16))
    val lights = VoxelConfig.Light.distinct
    val which = node(HIT).face.mux(
      (0 until 6).map(f => f -> U(lights.indexOf(VoxelConfig.Light(f)), 2 bits)) :+ (default -> U(
        0,
        2 bits
      )): _*
    )
    for ((at, i) <- Seq(12, 8, 4).zipWithIndex) {
      val table =
        Vec(for (l <- 0 until 4; v <- 0 until 16) yield U(v * 17 * lights.lift(l).getOrElse(0) >> 8, 8 bits))
      node(LIT)(i) := table(which @@ rgba(at, 4 bits).asUInt)
    }
  }

  val highlight = new Area {
    val node = line(4)
    for (i <- 0 to 2)
      node(SHOWN)(i) := Mux(node(CHOSEN), ((node(LIT)(i) * U(120 * 257)) >> 16).resize(8) + 125, node(LIT)(i))
  }

  val fog = new Area {
    for (i <- 0 to 2) {
      val apart = S(sky(i), 9 bits) - (False ## line(5)(SHOWN)(i)).asSInt
      line(5)(VEIL)(i) := (apart * (False ## line(5)(FOG)).asSInt).resize(18)
      val faded = (False ## line(6)(SHOWN)(i)).asSInt + (line(6)(VEIL)(i) >> 8).resize(9)
      line(6)(COLOR)(i) := Mux(line(6)(HIT).shown, faded(7 downto 0).asUInt, U(sky(i), 8 bits))
    }
  }

  /** How much of each ray is still to be filled, of 255. A ray's last layer leaves its slot ready for another ray. */
  val clear = new Area {
    val node = line(7)
    val slot = node(HIT).slot
    val left = Vec.fill(slots)(RegInit(U(255, 8 bits)))
    val weight = (left(slot) * node(ALPHA) >> 4).resize(8)
    node(WEIGHT) := weight
    when(node.isValid)(left(slot) := Mux(node(HIT).last, U(255, 8 bits), left(slot) - weight))
  }

  for (i <- 0 to 2) line(8)(LIGHT)(i) := line(8)(COLOR)(i) * line(8)(WEIGHT)

  val gather = new Area {
    val node = line(9)
    val slot = node(HIT).slot
    for (i <- 0 to 2) {
      val sums = Vec.fill(slots)(RegInit(U(0, 16 bits)))
      val sum = sums(slot) + node(LIGHT)(i)
      node(TOTAL)(i) := sum
      when(node.isValid)(sums(slot) := Mux(node(HIT).last, U(0, 16 bits), sum))
    }
  }

  val result = new Area {
    val node = line(10)
    for (i <- 0 to 2) {
      val half = node(TOTAL)(i) + 128
      node(PIXEL)(i) := ((half + (half >> 8)) >> 8).resized
    }
    io.down.valid := line(11).isValid && line(11)(HIT).last && !line(11)(HIT).pick
    io.down.pixel := line(11)(HIT).pixel
    io.down.rgb := line(11)(PIXEL)
  }
  line.build()
}
