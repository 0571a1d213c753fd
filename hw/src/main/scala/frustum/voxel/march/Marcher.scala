package frustum.voxel.march

import frustum.arithmetic.{LockstepPipeline, WideMultiplier}
import frustum.contract.voxel.{BlockTable, VoxelConfig}
import frustum.device.Tech
import frustum.voxel.world.{BlockFlags, WorldReadBus}
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Marches [[MarcherStages.slots]] rays in turn, a step of one of them each clock: a pipeline that feeds its own entrance, where a new
  * ray enters whenever one has ended. It never waits, and neither may what takes its hits.
  *
  * A step looks at the block the ray is in. From air it goes on to the far side of the largest cube of air that
  * the memory tells of, as far as borders of the fast axis go; from other blocks to the next one, whose border is
  * found by whether positions cross a whole number before the next border of the fast axis, and if both do, by
  * comparing the products of the ways and the slopes, which is exact. The model is `frustum.model.voxel.march.Marcher`.
  *
  * With `stages.retries` a ray makes its step again, a turn later, when its word was not `granted` or its hit not
  * `accepted`, both told in the clock in which they are asked for.
  */
case class Marcher(c: VoxelConfig, kinds: BlockTable, tech: Tech, stages: MarcherStages = MarcherStages.Fast)
    extends Component {
  private val table = BlockFlags(kinds)
  val io = new Bundle {
    val up = slave(Stream(RayStart(c)))
    val memory = master(WorldReadBus(c))
    val hits = master(Flow(FaceHit(c, stages.slots)))
    val step = out Bool () // a step is made
    val granted = stages.retries generate in(Bool())
    val accepted = stages.retries generate in(Bool())
  }
  private val whole = c.blockBits
  private val shift = c.fractionBits
  private def floor(at: SInt): SInt = at >> shift

  val RAY = Payload(VoxelRay(c))
  val PLACE = Payload(VoxelPlace(c))
  val END = Payload(SInt(c.endBits bits))
  val ENTRY = Payload(UInt(2 bits)) // 3: the ray starts in this block
  val PREVIOUS = Payload(UInt(BlockTable.IdBits bits))
  val SLOT = Payload(UInt(log2Up(stages.slots) bits))
  val BLOCK = Payload(Vec(SInt(whole bits), 3)) // fast axis first
  val INSIDE, OUT, FACE, LAST = Payload(Bool())
  val ID = Payload(UInt(BlockTable.IdBits bits))
  val REACH = Payload(UInt(5 bits))
  val RUN = Payload(Vec(UInt(c.slopeBits + 5 bits), 2)) // of the slopes over the reach
  val TO = Payload(Vec(UInt(shift + 1 bits), 2)) // ways to the next borders of the other axes
  val FAR = Payload(Vec(SInt(whole + shift bits), 2))
  val CROSS = Payload(Vec(UInt(shift + 1 + c.slopeBits bits), 2))
  val FITS, FIRST = Payload(Bool())
  val BACK = Payload(Vec(SInt(whole + shift bits), 2))
  val DENIED, AGAIN = Payload(Bool()) // the word was; so the step is to be made again

  val line = new LockstepPipeline(stages.slots)
  val tail = line.nodes.last

  /** A ray that goes round, or a new one. */
  val entrance = new Area {
    val again = tail.isValid && (!tail(LAST) || tail(AGAIN))
    val slot = RegInit(U(0, log2Up(stages.slots) bits))
    slot := Mux(slot === stages.slots - 1, U(0), slot + 1)
    val next = VoxelPlace(c) // after the step that ends at the tail
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
    val block = node(BLOCK)
    val xyz = for (k <- 0 to 2) yield RayAxes.xyz(node(RAY).fast, block, k)
    val beyond = Vec((0 to 2).map(k => !xyz(k).msb && (xyz(k) >> c.size.logs(k)) =/= 0))
    node(INSIDE) := !xyz.map(_.msb).reduce(_ || _)
    node(OUT) := beyond.asBits.orR || block(0).resize(c.endBits) > node(END)
    node(DENIED) := (if (stages.retries) !io.granted else False)
    io.memory.address := Cat((2 to 0 by -1).map { k =>
      val low = xyz(k)(c.size.logs(k) - 1 downto 0).asBits
      Mux(node(RAY).mirrored(k), ~low, low)
    }).asUInt
  }

  val decide = new Area {
    val node = line(stages.look + Marcher.MemoryLatency)
    val word = io.memory.word
    val block = node(INSIDE) && word.msb
    val id = word(BlockTable.IdBits - 1 downto 0).asUInt
    val joins = table.where(_.joins)(id)
    val opaque = table.where(_.opaque)(id)
    val reach = if (c.leaps.bits == 0) U(1, 5 bits)
    else {
      val distances = word(c.leaps.groups * c.leaps.bits - 1 downto 0).subdivideIn(c.leaps.groups slices)
      def group = Cat(c.leaps.axes.map(axis => node(RAY).mirrored(axis))).asUInt
      (if (c.leaps.groups == 1) distances(0) else distances(group)).asUInt.resize(5) + 1
    }
    val face = block && node(ENTRY) =/= 3 && !(joins && id === node(PREVIOUS))
    node(ID) := Mux(block && !node(OUT), id, U(0))
    node(FACE) := face && !node(OUT)
    node(LAST) := node(OUT) || face && opaque
    node(REACH) := Mux(node(INSIDE) && !word.msb, reach, U(1))
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
  private def move(slopes: UInt): SInt = (slopes ## B(0, c.eyeBits bits)).asUInt.resize(whole + shift).asSInt

  val far = new Area {
    val node = line(stages.far)
    for (i <- 0 to 1) node(FAR)(i) := node(PLACE).at(i) + move(node(RUN)(i))
  }

  /** Ways to the next borders, each times the other slope: two clocks. */
  val cross = new Area {
    val node = line(stages.choose - 2)
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
    // The first is before the second, or together with it and of an earlier axis: the carry of second - first - (0 or 1).
    val ties = node(RAY).fast =/= 1
    val before = (((node(CROSS)(1) ## True).asUInt +^ (~node(CROSS)(0) ## ties).asUInt)).msb
    node(FITS) := fits.asBits.andR
    node(FIRST) := crosses(0) && (!crosses(1) || before)
  }
  line.build()
}

object Marcher {

  /** Clocks from address to word. */
  val MemoryLatency = 1
}
