package frustum.voxel.march

import frustum.arithmetic.{LockstepPipeline, Multiplier16, WideMultiplier}
import frustum.contract.voxel.{BlockTable, VoxelConfig}
import frustum.device.Tech
import frustum.voxel.world.{BlockFlags, LeapWord, WorldPlace, WorldReadBus}
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Marches [[MarcherStages.slots]] rays in turn, a step of one of them each cycle: a pipeline that feeds its own
  * entrance, where a new ray enters whenever one has ended. It never stalls, and its hits must be taken at once.
  *
  * A step reads the block of the ray. From air it goes to the far side of the largest cube of air in the memory's word,
  * as far as borders of the fast axis go; from other blocks to the next one, whose border is found by whether positions
  * cross an integer before the next border of the fast axis, and if both do, by comparing the products of the distances
  * and the slopes, which is exact. The model is `frustum.model.voxel.march.Marcher`.
  *
  * With `stages.retries` a ray repeats its step one revolution later if its word was not `granted` or its hit not
  * `accepted`; both are valid in the cycle of the request.
  */
case class Marcher(
    config: VoxelConfig,
    kinds: BlockTable,
    tech: Tech = Tech.Generic,
    stages: MarcherStages = MarcherStages.Fast
) extends Component {
  private val table = BlockFlags(kinds)
  val io = new Bundle {
    val up = slave(Stream(RayStart(config)))
    val memory = master(WorldReadBus(config))
    val hits = master(Flow(FaceHit(config, stages.slots)))
    val step = out Bool () // a step is made
    val granted = stages.retries generate in(Bool())
    val accepted = stages.retries generate in(Bool())
  }
  private val whole = config.blockBits
  private val shift = config.fractionBits
  private def floor(at: SInt): SInt = at >> shift

  val RAY = Payload(VoxelRay(config))
  val PLACE = Payload(VoxelPlace(config))
  val END = Payload(SInt(config.endBits bits))
  val ENTRY = Payload(UInt(2 bits)) // axis of the border, or 3: the ray starts in this block
  val PREVIOUS = Payload(UInt(BlockTable.IdBits bits))
  val SLOT = Payload(UInt(log2Up(stages.slots) bits))
  val BLOCK = Payload(Vec(SInt(whole bits), 3)) // fast axis first
  val INSIDE, OUT, FACE, LAST = Payload(Bool())
  val ID = Payload(UInt(BlockTable.IdBits bits))
  val REACH = Payload(UInt(LeapWord.SideBits bits))
  val RUN = Payload(Vec(UInt(config.slopeBits + LeapWord.SideBits bits), 2)) // slopes times reach
  val TO = Payload(Vec(UInt(shift + 1 bits), 2)) // distances to the next borders of the other axes
  val FAR = Payload(Vec(SInt(whole + shift bits), 2))
  val CROSS = Payload(Vec(UInt(shift + 1 + config.slopeBits bits), 2))
  val FITS, FIRST = Payload(Bool())
  val BACK = Payload(Vec(SInt(whole + shift bits), 2))
  val DENIED = Payload(Bool()) // the memory did not grant the word
  val AGAIN = Payload(Bool()) // the step is repeated

  val line = new LockstepPipeline(stages.slots)
  val tail = line.nodes.last

  /** A ray of the ring, or a new one. */
  val entrance = new Area {
    val again = tail.isValid && (!tail(LAST) || tail(AGAIN))
    val slot = RegInit(U(0, log2Up(stages.slots) bits))
    slot := Mux(slot === stages.slots - 1, U(0), slot + 1)
    val next = VoxelPlace(config) // the place after the step that ends at the tail
    val leap = !tail(AGAIN) && (tail(FITS) || tail(REACH) =/= 1)
    next.plane := tail(PLACE).plane + Mux(leap, tail(REACH) - (!tail(FITS)).asUInt, U(0)).resize(whole).asSInt
    for (i <- 0 to 1) {
      next.at(i) := Mux(leap, Mux(tail(FITS), tail(FAR)(i), tail(BACK)(i)), tail(PLACE).at(i))
      next.past(i) := !leap && (tail(PLACE).past(i) || !tail(AGAIN) && (tail(FIRST) ^ Bool(i == 1)))
    }
    io.up.ready := !again
    line(0).valid := again || io.up.valid
    line(0)(RAY) := Mux(again, tail(RAY), io.up.ray)
    line(0)(PLACE) := Mux(again, next, io.up.place)
    line(0)(END) := Mux(again, tail(END), io.up.end)
    val entry = Mux(leap, U(0, 2 bits), Mux(tail(FIRST), U(1), U(2)))
    line(0)(ENTRY) := Mux(again, Mux(tail(AGAIN), tail(ENTRY), entry), U(3))
    line(0)(PREVIOUS) := Mux(again, Mux(tail(AGAIN), tail(PREVIOUS), tail(ID)), U(0))
    line(0)(SLOT) := slot
    io.step := tail.isValid && !tail(AGAIN)
  }

  val where = new Area {
    val node = line(stages.where)
    val place = node(PLACE)
    node(BLOCK)(0) := place.plane
    for (i <- 0 to 1) node(BLOCK)(i + 1) := floor(place.at(i)) + place.past(i).asUInt.resize(whole).asSInt
  }

  val look = new Area {
    val node = line(stages.look)
    val xyz = for (k <- 0 to 2) yield RayAxes.xyz(node(RAY).fast, node(BLOCK), k)
    val beyond = Vec((0 to 2).map(k => WorldPlace.beyond(config.size, xyz(k), k)))
    node(INSIDE) := !xyz.map(_.msb).reduce(_ || _) // where it is not beyond
    node(OUT) := beyond.asBits.orR || node(BLOCK)(0).resize(config.endBits) > node(END)
    node(DENIED) := (if (stages.retries) !io.granted else False)
    // size - 1 - place, of which the address takes the lower bits, is the place with all of them inverted
    val place = (0 to 2).map(k => Mux(node(RAY).mirrored(k), ~xyz(k), xyz(k)))
    io.memory.address := WorldPlace.address(config.size, place)
  }

  val decide = new Area {
    val node = line(stages.decide)
    val word = io.memory.word
    val block = node(INSIDE) && LeapWord.isBlock(word)
    val id = LeapWord.id(word)
    val joins = table.where(_.joins)(id)
    val opaque = table.where(_.opaque)(id)
    def group = Cat(config.leaps.axes.map(axis => node(RAY).mirrored(axis))).asUInt
    val reach = LeapWord.side(config.leaps, word, group)
    val face = block && node(ENTRY) =/= 3 && !(joins && id === node(PREVIOUS))
    node(ID) := Mux(block && !node(OUT), id, U(0))
    node(FACE) := face && !node(OUT)
    node(LAST) := node(OUT) || face && opaque
    node(REACH) := Mux(node(INSIDE) && !LeapWord.isBlock(word), reach, U(1))
  }

  val steps = new Area {
    val node = line(stages.steps)
    for (i <- 0 to 1) node(RUN)(i) := node(REACH) * node(RAY).slopes(i)
    io.hits.valid := node.isValid && (node(FACE) || node(LAST)) && !node(DENIED)
    node(AGAIN) := (if (stages.retries) node(DENIED) || io.hits.valid && !io.accepted else False)
    io.hits.ray := node(RAY)
    io.hits.slot := node(SLOT)
    io.hits.face := node(FACE)
    io.hits.last := node(LAST)
    io.hits.id := node(ID)
    io.hits.entry := node(ENTRY)
    io.hits.at := node(PLACE).at
    for (k <- 0 to 2) io.hits.block(k) := node(BLOCK)(k).asUInt.resized
  }

  /** What slopes, added up, move a position by. */
  private def move(slopes: UInt): SInt = (slopes ## B(0, config.eyeBits bits)).asUInt.resize(whole + shift).asSInt

  val far = new Area {
    val node = line(stages.far)
    for (i <- 0 to 1) node(FAR)(i) := node(PLACE).at(i) + move(node(RUN)(i))
  }

  /** Ways to the next borders, each times the other slope. */
  val cross = new Area {
    val node = line(stages.choose - Multiplier16.Latency)
    for (i <- 0 to 1) {
      val fraction = node(PLACE).at(i)(shift - 1 downto 0).asUInt
      val slope = node(RAY).slopes(1 - i)
      node(TO)(i) := U(1 << shift, shift + 1 bits) - fraction.resize(shift + 1) - node(RAY).low(i).asUInt
      if (stages.narrow) {
        val product = WideMultiplier(tech, shift + 2)
        product.io.a := (False ## node(TO)(i)).asSInt
        product.io.b := slope.resized
        line(stages.choose)(CROSS)(i) := product.io.product.asUInt.resized
      } else {
        val after = line(stages.choose - 1)
        after(CROSS)(i) := after(TO)(i) * after(RAY).slopes(1 - i)
      }
    }
  }

  val choose = new Area {
    val node = line(stages.choose)
    val crosses = Vec(Bool(), 2)
    val fits = Vec(Bool(), 2)
    for (i <- 0 to 1) {
      node(BACK)(i) := node(FAR)(i) - move(node(RAY).slopes(i))
      fits(i) := floor(node(FAR)(i)) - node(BLOCK)(i + 1) < node(REACH).resize(whole).asSInt
      crosses(i) := !node(PLACE).past(i) && floor(node(FAR)(i)) =/= floor(node(PLACE).at(i))
    }
    // The first is before the second, or together with it and of an earlier axis: the carry of
    // second - first - (0 or 1).
    val ties = node(RAY).fast =/= 1
    val before = (((node(CROSS)(1) ## True).asUInt +^ (~node(CROSS)(0) ## ties).asUInt)).msb
    node(FITS) := fits.asBits.andR
    node(FIRST) := crosses(0) && (!crosses(1) || before)
  }
  line.build()
}
