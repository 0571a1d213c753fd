package frustum.voxel.compact

import frustum.arithmetic.Multiplier16
import frustum.contract.voxel.{BlockTable, VoxelConfig, VoxelTextures}
import frustum.device.Tech
import frustum.voxel.march.{OrderedPixel, PointedAt, TexelHit}
import frustum.voxel.world.VoxelTables
import spinal.core._
import spinal.lib._

/** What [[LayerComposite]] does, a layer at a time, with one multiplier and the rays' layers in block RAM: 14 clocks a layer, fewer for one of sky. Colours
  * come as RGB565, the upper bits of each channel. The model is the same.
  *
  * @param slots rays at one time, each with its own layers
  */
case class CompactComposite(c: VoxelConfig, kinds: BlockTable, textures: VoxelTextures, slots: Int, tech: Tech)
    extends Component {
  val io = new Bundle {
    val pointedAt = in(PointedAt(c))
    val up = slave(Stream(TexelHit(c, slots)))
    val down = master(Flow(OrderedPixel()))
    val done = out Bool () // a ray
  }
  private val sky = Seq(16, 8, 0).map(at => c.sky >> at & 255)

  val clock = RegInit(U(0, 4 bits)) // 0 idle, 14 the last
  val hit = Reg(TexelHit(c, slots))
  val chosen = Reg(Bool())
  val beyond = Reg(UInt(16 bits))
  io.up.ready := clock === 0 || clock === 14
  when(io.up.ready)(clock := 0) otherwise (clock := clock + 1)
  when(io.up.fire) {
    hit := io.up.payload
    beyond := Mux(io.up.far > c.fogSquared, io.up.far - c.fogSquared, U(0)).resized
    chosen := io.pointedAt.valid && io.pointedAt.face === io.up.face && io.pointedAt.block === io.up.block
    clock := Mux(io.up.shown, U(1, 4 bits), U(3, 4 bits))
  }

  /** Texture by id and face, colour index by texel, colour by texture and index: there from clock 4 on. */
  val tables = VoxelTables(kinds, textures)
  tables.io.id := hit.id
  tables.io.face := hit.face
  tables.io.u := hit.u
  tables.io.v := hit.v
  val rgba = tables.io.rgba
  val alpha = Mux(hit.shown, rgba(3 downto 0).asUInt.resize(5) + rgba(3).asUInt, U(16))

  /** Channels one after the other, two clocks each: the texel's at 4, 6, 8, what is shown at 5, 7, 9, in fog at 8, 10, 12. */
  val light = new Area {
    val levels = VoxelConfig.Light.distinct
    val table = Mem(
      Bits(8 bits),
      for (pointed <- 0 to 1; l <- 0 until 4; v <- 0 until 16) yield {
        val lit = v * 17 * levels.lift(l).getOrElse(0) >> 8
        B(if (pointed == 1) (lit * 120 * 257 >> 16) + 125 else lit, 8 bits)
      }
    )
    val level = hit.face.mux((0 until 6).map(f =>
      f -> U(levels.indexOf(VoxelConfig.Light(f)), 2 bits)
    ) :+ (default -> U(0, 2 bits)): _*)
    val value = clock.mux(4 -> rgba(15 downto 12), 6 -> rgba(11 downto 8), default -> rgba(7 downto 4))
    val shown = table.readSync((chosen.asUInt ## level ## value).asUInt).asUInt // at 5, 7, 9
  }

  val multiplier = Multiplier16(tech, signedA = true, signedB = false, add = true)
  multiplier.io.enable := True
  val product = multiplier.io.product

  val fog = Reg(UInt(9 bits))
  val above = clock.mux(5 -> U(sky(0), 8 bits), 7 -> U(sky(1), 8 bits), default -> U(sky(2), 8 bits))
  val color = Reg(UInt(8 bits)) // at 8, 10, 12
  when(clock === 3)(fog := (if (c.fog) product(24 downto 16).asUInt else U(0, 9 bits)))
  when(clock === 7)(color := Mux(hit.shown, product(15 downto 8).asUInt, U(sky(0), 8 bits)))
  when(clock === 9)(color := Mux(hit.shown, product(15 downto 8).asUInt, U(sky(1), 8 bits)))
  when(clock === 11)(color := Mux(hit.shown, product(15 downto 8).asUInt, U(sky(2), 8 bits)))

  /** Of each slot: three channels' light and what is still clear, of 255. A slot is `fresh` when its ray has no layer yet. */
  val layers = new Area {
    val memory = Mem(Bits(16 bits), 4 * slots)
    val fresh = RegInit(B((BigInt(1) << slots) - 1, slots bits))
    val first = fresh(hit.slot)
    val which = clock.mux(7 -> U(0, 2 bits), 9 -> U(1, 2 bits), 11 -> U(2, 2 bits), default -> U(3, 2 bits))
    val slot = Mux(io.up.ready, io.up.slot, hit.slot)
    val word = memory.readSync(slot @@ which).asUInt
    val clear = Reg(UInt(8 bits))
    val weight = Reg(UInt(8 bits))
    val before = Mux(first, U(0, 16 bits), word)
    val starts = RegNext(io.up.fire, False)
    when(starts)(clear := Mux(first, U(255), word(7 downto 0)))
    when(clock === 6)(weight := product(11 downto 4).asUInt)
    val write = clock.mux(7 -> True, 10 -> True, 12 -> True, 14 -> True, default -> False)
    val place = clock.mux(10 -> U(0, 2 bits), 12 -> U(1, 2 bits), 14 -> U(2, 2 bits), default -> U(3, 2 bits))
    val data = Mux(clock === 7, (clear - weight).resize(16), product(15 downto 0).asUInt)
    memory.write(hit.slot @@ place, data.asBits, write)
    when(clock === 14)(fresh(hit.slot) := hit.last)
  }

  val zero = B(0, 16 bits)
  multiplier.io.a := clock.mux(
    1 -> B(c.fogStep, 16 bits),
    4 -> alpha.asBits.resize(16),
    5 -> (above.resize(9).asSInt - light.shown.resize(9).asSInt).resize(16).asBits,
    7 -> (above.resize(9).asSInt - light.shown.resize(9).asSInt).resize(16).asBits,
    9 -> (above.resize(9).asSInt - light.shown.resize(9).asSInt).resize(16).asBits,
    default -> color.asBits.resize(16)
  )
  multiplier.io.b := clock.mux(
    1 -> beyond.asBits,
    4 -> layers.clear.asBits.resize(16),
    5 -> fog.asBits.resize(16),
    7 -> fog.asBits.resize(16),
    9 -> fog.asBits.resize(16),
    default -> layers.weight.asBits.resize(16)
  )
  multiplier.io.addend := B(0, 16 bits) ## clock.mux(
    1 -> zero,
    4 -> zero,
    5 -> light.shown ## B(0, 8 bits),
    7 -> light.shown ## B(0, 8 bits),
    9 -> light.shown ## B(0, 8 bits),
    default -> layers.before.asBits
  )

  val result = new Area {
    val half = product(15 downto 0).asUInt + 128
    val value = ((half + (half >> 8)) >> 8).resize(8)
    val pixel = Reg(OrderedPixel())
    val valid = RegNext(clock === 14 && hit.last && !hit.pick, False)
    when(clock === 10)(pixel.color(15 downto 11) := value(7 downto 3).asBits)
    when(clock === 12)(pixel.color(10 downto 5) := value(7 downto 2).asBits)
    when(clock === 14) {
      pixel.color(4 downto 0) := value(7 downto 3).asBits
      pixel.tag := hit.pixel.resized
    }
    io.down.valid := valid
    io.down.payload := pixel
    io.done := RegNext(clock === 14 && hit.last, False)
  }
}
