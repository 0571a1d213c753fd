package frustum.voxel.compact

import frustum.arithmetic.Multiplier16
import frustum.contract.voxel.{BlockTable, FaceLight, VoxelConfig, VoxelTextures}
import frustum.device.Tech
import frustum.voxel.march.{FaceLevel, Fog, LayerBlend, OrderedPixel, PointedAt, TexelHit}
import frustum.voxel.world.VoxelTables
import spinal.core._
import spinal.lib._

/** What [[LayerComposite]] does, a layer at a time, with one multiplier and the rays' layers in block RAM: 14 cycles
  * per layer, 12 for one of sky. Colours come as RGB565, the upper bits of each channel. The model is the same.
  *
  * @param slots rays at one time, each with its own layers
  */
case class CompactComposite(
    config: VoxelConfig,
    kinds: BlockTable,
    textures: VoxelTextures,
    slots: Int,
    tech: Tech = Tech.Generic
) extends Component {
  import CompactComposite._
  val io = new Bundle {
    val pointedAt = in(PointedAt(config))
    val up = slave(Stream(TexelHit(config, slots)))
    val down = master(Flow(OrderedPixel()))
    val done = out Bool () // a ray is done
  }
  private val sky = config.skyChannels.map(U(_, 8 bits))

  val step = RegInit(U(Idle, 4 bits))
  val hit = Reg(TexelHit(config, slots))
  val chosen = Reg(Bool())
  val beyond = Reg(UInt(16 bits))
  io.up.ready := step === Idle || step === Last
  when(io.up.ready)(step := Idle) otherwise (step := step + 1)
  when(io.up.fire) {
    hit := io.up.payload
    beyond := Fog.beyond(config, io.up.far).resized
    chosen := io.pointedAt.is(io.up.payload)
    step := Mux(io.up.shown, U(MultiplyFog, 4 bits), U(Sky, 4 bits))
  }

  /** The texel, from `MultiplyOpacity` on. */
  val tables = VoxelTables(kinds, textures)
  tables.io.id := hit.id
  tables.io.face := hit.face
  tables.io.u := hit.u
  tables.io.v := hit.v
  val rgba = tables.io.rgba

  /** What the i-th channel has at a step, the last one at all others. */
  private def channel[T <: Data](at: Int => Int)(of: Int => T): T =
    step.mux(at(0) -> of(0), at(1) -> of(1), default -> of(2))

  val light = new Area {
    val table = Mem(
      Bits(8 bits),
      (FaceLevel.lit ++ FaceLevel.lit.map(FaceLight.highlighted)).map(B(_, 8 bits))
    )
    val value = channel(LookUp)(i => rgba(12 - 4 * i, 4 bits))
    val shown = table.readSync((chosen.asUInt ## FaceLevel.of(hit.face) ## value).asUInt).asUInt // at MultiplyVeil
  }

  val multiplier = Multiplier16(tech, signedA = true, signedB = false, add = true)
  multiplier.io.enable := True
  val product = multiplier.io.product

  val fog = Reg(UInt(Fog.WeightBits bits))
  val above = channel(MultiplyVeil)(sky(_))
  val color = Reg(UInt(8 bits)) // a channel, valid at MultiplyLight
  when(step === FogProduct)(fog := Fog.weight(config, product.asUInt))
  for (i <- 0 to 2) when(step === VeilProduct(i))(color := Mux(hit.shown, product(15 downto 8).asUInt, sky(i)))

  /** A slot has three words of channels' light and one of the remaining transparency, of 255. It is `fresh` when its
    * ray has no layer yet.
    */
  val layers = new Area {
    private def place(n: Int) = U(n, 2 bits)
    val clearPlace = place(3)
    val memory = Mem(Bits(16 bits), 4 * slots)
    val fresh = RegInit(B((BigInt(1) << slots) - 1, slots bits))
    val first = fresh(hit.slot)
    val slot = Mux(io.up.ready, io.up.slot, hit.slot)
    val which = step.mux((0 to 2).map(i => VeilProduct(i) -> place(i)) :+ (default -> clearPlace): _*)
    val word = memory.readSync(slot @@ which).asUInt
    val clear = Reg(UInt(8 bits))
    val weight = Reg(UInt(8 bits))
    val before = Mux(first, U(0, 16 bits), word)
    val starts = RegNext(io.up.fire, False)
    when(starts)(clear := Mux(first, U(255), word(7 downto 0)))
    when(step === OpacityProduct)(weight := product(11 downto 4).asUInt)
    val write = (Clear +: (0 to 2).map(LightProduct)).map(step === _).reduce(_ || _)
    val writePlace = step.mux((0 to 2).map(i => LightProduct(i) -> place(i)) :+ (default -> clearPlace): _*)
    val data = Mux(step === Clear, (clear - weight).resize(16), product(15 downto 0).asUInt)
    memory.write(hit.slot @@ writePlace, data.asBits, write)
    when(step === Last)(fresh(hit.slot) := hit.last)
  }

  /** Factors and addend of each step at which they matter; those of light where no other are. */
  val operands = new Area {
    val opacity = LayerBlend.opacity(hit.shown, rgba)
    val veil = Fog.difference(above, light.shown).resize(16).asBits
    private def choice(beyond: Bits, opacity: Bits, veil: Bits, light: Bits) =
      step.mux(
        Seq(MultiplyFog -> beyond, MultiplyOpacity -> opacity) ++ (0 to 2).map(MultiplyVeil(_) -> veil) :+
          (default -> light): _*
      )
    private val none = B(0, 16 bits)
    multiplier.io.a := choice(B(config.fogStep, 16 bits), opacity.asBits.resize(16), veil, color.asBits.resize(16))
    multiplier.io.b := choice(
      beyond.asBits,
      layers.clear.asBits.resize(16),
      fog.asBits.resize(16),
      layers.weight.asBits.resize(16)
    )
    multiplier.io.addend := none ## choice(none, none, light.shown ## B(0, 8 bits), layers.before.asBits)
  }

  val result = new Area {
    val value = LayerBlend.channel(product(15 downto 0).asUInt)
    val pixel = Reg(OrderedPixel())
    val valid = RegNext(step === Last && hit.last && !hit.pick, False)
    when(step === LightProduct(0))(pixel.color(15 downto 11) := value(7 downto 3).asBits)
    when(step === LightProduct(1))(pixel.color(10 downto 5) := value(7 downto 2).asBits)
    when(step === LightProduct(2)) {
      pixel.color(4 downto 0) := value(7 downto 3).asBits
      pixel.tag := hit.pixel.resized
    }
    io.down.valid := valid
    io.down.payload := pixel
    io.done := RegNext(step === Last && hit.last, False)
  }
}

/** Steps of a layer. The multiplier is given fog's weight, then opacity, then the channels' veils and lights in turn:
  * two cycles per channel, those of one between those of the next.
  */
object CompactComposite {
  private val Idle = 0
  private val MultiplyFog = 1
  private val FogProduct = MultiplyFog + Multiplier16.Latency
  private val MultiplyOpacity = MultiplyFog + VoxelTables.Latency
  private val OpacityProduct = MultiplyOpacity + Multiplier16.Latency

  private val Clear = OpacityProduct + 1 // the step that writes the remaining transparency

  // A channel, red first, is looked up, fades in fog, and is added to that of the layers before.
  private val LookUp: Int => Int = MultiplyOpacity + 2 * _
  private val MultiplyVeil: Int => Int = LookUp(_) + 1
  private val VeilProduct: Int => Int = MultiplyVeil(_) + Multiplier16.Latency
  private val MultiplyLight: Int => Int = VeilProduct(_) + 1
  private val LightProduct: Int => Int = MultiplyLight(_) + Multiplier16.Latency
  private val Last = LightProduct(2)

  /** First step of a layer of sky: the transparency arrives in the cycle in which it is needed. */
  private val Sky = MultiplyOpacity - 1

  private val multiplications =
    Seq(MultiplyFog, MultiplyOpacity) ++ (0 to 2).flatMap(i => Seq(MultiplyVeil(i), MultiplyLight(i)))
  require(multiplications.distinct == multiplications, s"two multiplications at one of the steps $multiplications")
}
