package frustum.raster.link

import frustum.contract.raster.Command
import spinal.core._
import spinal.lib._

/** Words of a command that belong together: a pair where the store keeps pairs, otherwise a single one. */
case class CommandGroup() extends Bundle {
  val words = Bits(32 bits) // a single word is in the lower half
  val first = Bool() // the first group of the command
  val last = Bool() // the last group of the command

  def single: Bits = words(15 downto 0)
}

/** Reads commands as [[Framer]] delivers them, `opcode << 8 | length` and the payload, and offers their groups to the
  * unit of the command: single words, but pairs of the states, vertices and triangles that follow a first word.
  *
  * A single word but a texel is stable for a cycle before it is offered: checks of it may come from a register. A unit
  * that takes a group with `refuse` gets no further one of the command. Opcodes and lengths are not checked again.
  *
  * A pair or a single word takes three cycles and those of its unit, a texel two.
  */
case class CommandReader() extends Component {
  val io = new Bundle {
    val words = slave(Stream(Bits(16 bits)))
    val open = in Bool () // a frame is begun: most commands are refused otherwise
    val opcode = out(Reg(UInt(3 bits))) // opcode of the current command
    val group = master(Stream(CommandGroup()))
    val refuse = in Bool () // refuses the command of the group that is taken
    val turn = in Bool () // in a group that is offered, the lower thirty bits turn by ten to the right
    val passing = master(Flow(Bits(16 bits))) // a word of the payload as it is taken
    val accepted, refused = out Bool () // pulses at a command's end
  }
  object State extends SpinalEnum(binaryOneHot) {
    val header, dispatch, first, second, offer, skip, finish = newElement()
  }
  val state = RegInit(State.header)
  val left = Reg(UInt(7 bits)) // remaining payload words
  val none = Reg(Bool()) // no payload words remain
  val words = Reg(Bits(32 bits))
  val isFirst = Reg(Bool())
  val refused = Reg(Bool())

  private def ofOne(commands: Command*) = commands.map(io.opcode === _.opcode).orR
  val pairs = !isFirst && ofOne(Command.State, Command.Vertices, Command.Triangles)

  val take = state === State.first || state === State.second || (state === State.skip && !none)
  val took = take && io.words.valid
  io.words.ready := take || state === State.header
  io.passing.valid := took
  io.passing.payload := io.words.payload
  when(took) {
    left := left - 1
    none := left === 1
  }
  when(took || io.turn) {
    words := Mux(
      io.turn,
      words(31 downto 30) ## words(9 downto 0) ## words(29 downto 10),
      words(15 downto 0) ## io.words.payload
    )
  }

  val stood = RegNext(!took)
  val texel = !isFirst && io.opcode === Command.Texels.opcode
  io.group.valid := state === State.offer && (stood || pairs || texel)
  io.group.words := words
  io.group.first := isFirst
  io.group.last := none
  io.accepted := state === State.finish && !refused
  io.refused := state === State.finish && refused

  switch(state) {
    is(State.header) {
      io.opcode := io.words.payload(10 downto 8).asUInt
      left := io.words.payload(6 downto 0).asUInt
      none := io.words.payload(6 downto 0) === 0
      isFirst := True
      refused := False
      when(io.words.valid)(state := State.dispatch)
    }
    is(State.dispatch) {
      state := State.first
      when(!ofOne(Command.all: _*) || !io.open && !ofOne(Command.Begin, Command.Texels)) {
        refused := True
        state := State.skip
      }
    }
    is(State.first)(when(took)(state := Mux(pairs, State.second(), State.offer())))
    is(State.second)(when(took)(state := State.offer))
    is(State.offer) {
      when(io.group.fire) {
        isFirst := False
        refused := io.refuse
        state := State.first
        when(none)(state := State.finish)
        when(io.refuse)(state := State.skip)
      }
    }
    is(State.skip)(when(none)(state := State.finish))
    is(State.finish)(state := State.header)
  }
}
