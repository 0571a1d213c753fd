package frustum.raster

import frustum.contract.raster.{
  Command,
  FixedState,
  RasterConfig,
  RenderState,
  RenderStateLayout,
  StateLayout,
  StoreLayout,
  StoredState,
  StoredStateLayout
}
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.raster.link.{CommandDecoder => DecoderModel}
import frustum.raster.link.{CommandReader, SentStates, StateCommand, StorePort, StoreWrite}
import frustum.raster.scan.{DrawToken, RenderStateLoader}
import frustum.raster.store.{RenderStateWord, Store}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._
import spinal.lib.sim.{StreamDriver, StreamMonitor, StreamReadyRandomizer}

import scala.collection.mutable
import scala.util.Random

/** The fields of a render state over five words of the wire, so three of the store, with spare bits between them. */
object LongState extends StateLayout("long render state") {
  private val WireWords = 5
  private val low = Array.fill(WireWords)(0)
  for (field <- RenderStateLayout.fields) {
    val word = low.indexOf(low.min)
    unsigned(field.name, bits(word, low(word) + field.width - 1, low(word)), field.meaning)
    low(word) += field.width + 1
  }
}

/** The path of render states: from the words of a command through the store to the fragment stages. */
case class RenderStatePath(config: RasterConfig, stored: StoredStateLayout) extends Component {
  val layout = StoreLayout(config, stored)
  val io = new Bundle {
    val words = slave(Stream(Bits(16 bits)))
    val refused = out Bool ()
    val written = master(Flow(StoreWrite(layout)))
    val up = slave(Stream(DrawToken(config)))
    val down = master(Stream(DrawToken(config)))
    val current = out(RenderStateWord())
  }
  val reader = CommandReader()
  val states = SentStates()
  val command = StateCommand(config, stored)
  val port = StorePort(layout)
  val store = Store(layout, clients = 2)
  val loader = RenderStateLoader(config, stored)

  reader.io.words << io.words
  reader.io.open := True
  reader.io.turn := False
  reader.io.group >> command.io.up.group
  reader.io.refuse := command.io.up.refuse
  io.refused := reader.io.refused
  states.io.fresh := False
  states.io.named.valid := reader.io.group.valid && reader.io.group.first
  states.io.named.payload := reader.io.group.single
  states.io.sends := command.io.sends
  command.io.index := states.io.index
  command.io.missing := states.io.missing
  command.io.found := states.io.found
  port.io.write << command.io.writes
  port.io.read.valid := False
  port.io.read.payload := 0
  port.io.bank := 0
  io.written.valid := command.io.writes.fire
  io.written.payload := command.io.writes.payload

  store.io.clients(0) <> loader.io.store
  store.io.clients(1) <> port.io.store
  loader.io.flush := False
  loader.io.bank := 0
  loader.io.busy := False
  loader.io.up << io.up
  loader.io.down >> io.down
  io.current := loader.io.current
}

class RenderStatePathTest extends AnyFunSuite with Simulated {
  private val some = FixedState.fields("alphaRef" -> 5).bits("textureBase", mask = 3, value = 1)

  for {
    (name, stored) <- Seq("one" -> StoredState, "three" -> new StoredStateLayout(LongState))
    (choice, fixed) <- Seq("free" -> FixedState.None, "partly constant" -> some)
  } test(s"render states of $name store word(s), $choice, arrive as they were sent; the store is the model's") {
    check(RasterConfig(64, 64, maxVertices = 16, maxTriangles = 16, fixed = fixed), stored, seed = 15)
  }

  test("an odd number of words of the wire is made even, as words are stored in pairs") {
    assert(LongState.words == 6 && new StoredStateLayout(LongState).words == 3)
    assert(RenderStateLayout.words == 2 && StoredState.words == 1)
  }

  /** Sends states, some of them refused, and then lets each that was stored be loaded, several times in random order.
    */
  private def check(config: RasterConfig, stored: StoredStateLayout, seed: Int): Unit = {
    val random = new Random(seed)
    val wire = stored.wire
    val commands = Seq.fill(60) {
      val values = wire.fields.map { field =>
        val (fixed, value) = (config.fixed(field), random.nextInt() & field.ones)
        field -> (if (random.nextInt(8) == 0) value else value & ~fixed.mask | fixed.value)
      }
      // Spare bits are random too: nothing may depend on them.
      val words = wire.encode(values: _*).zipWithIndex.map { case (w, n) => w | random.nextInt(65536) & ~wire.mask(n) }
      (if (random.nextInt(10) == 0) random.nextInt(65536) else random.nextInt(RenderState.Count)) +: words
    }
    val model = new DecoderModel(config, stored)
    model.execute(Command.Begin.opcode, Seq(0, 0, 0, 0))
    commands.foreach(model.execute(Command.State.opcode, _))
    val accepted = commands.filter(c => c.head < RenderState.Count && config.fixed.accepts(c.tail, wire))
    assert(model.refused == commands.length - accepted.length && model.refused > 0 && accepted.length > 20)
    val sent = accepted.map(c => c.head -> wire.fields.map(f => f.name -> f.of(c.tail)).toMap).toMap

    val name = s"RenderStatePath_${stored.words}_${config.fixed.constants.size}"
    FrustumSim.compile(name)(RenderStatePath(config, stored)).doSim(seed) { dut =>
      val written = mutable.Map.empty[Int, Long]
      var refused = 0
      val words = mutable.Queue(commands.flatMap(c => (Command.State.opcode << 8 | c.length) +: c): _*)
      val loads = mutable.Queue.fill(100)(sent.keys.toSeq(random.nextInt(sent.size)))
      val expected = loads.clone()
      var loaded = 0
      StreamDriver(dut.io.words, dut.clockDomain) { payload =>
        words.nonEmpty && { payload #= words.dequeue(); true }
      }
      dut.io.up.valid #= false
      StreamReadyRandomizer(dut.io.down, dut.clockDomain)
      StreamMonitor(dut.io.down, dut.clockDomain) { token =>
        assert(token.state.toInt == expected.head)
        for ((field, value) <- sent(expected.dequeue())) {
          val got = dut.io.current.elements.collectFirst {
            case (`field`, flag: Bool)        => if (flag.toBoolean) 1 else 0
            case (`field`, number: BitVector) => number.toInt
          }
          assert(got.contains(value), s"seed $seed: $field of state ${token.state.toInt}")
        }
        loaded += 1
      }
      dut.clockDomain.onSamplings {
        if (dut.io.refused.toBoolean) refused += 1
        if (dut.io.written.valid.toBoolean) written(dut.io.written.address.toInt) = dut.io.written.data.toLong
      }
      SimTimeout(2000000)
      dut.clockDomain.forkStimulus(10)
      dut.clockDomain.waitSamplingWhere(words.isEmpty)
      dut.clockDomain.waitSampling(50)
      def meant(address: Int, word: Long) = word & dut.layout.mask(address) & 0xffffffffL
      val should = model.banks(0).indices.filter(model.banks(0)(_) != DecoderModel.Unwritten)
      assert(written.keySet == should.toSet && refused == model.refused, s"seed $seed")
      for (a <- should) assert(meant(a, written(a)) == meant(a, model.banks(0)(a)), s"seed $seed, word $a")

      StreamDriver(dut.io.up, dut.clockDomain) { token =>
        loads.nonEmpty && { token.tileEnd #= false; token.state #= loads.dequeue(); true }
      }
      dut.clockDomain.waitSampling(3000)
      assert(loaded == 100, s"seed $seed: $loaded of 100 tokens passed")
    }
  }
}
