package frustum.raster.link

import frustum.contract.raster.{Command, RasterConfig, StoreLayout}
import frustum.raster.store.{FrameJob, StoreBus}
import frustum.raster.texture.TexelWrite
import spinal.core._
import spinal.lib._

/** Executes checked commands, see [[frustum.contract.raster.Command]], one at a time: [[CommandReader]] cuts them into
  * groups of words and each has a unit that takes its groups. Vertices go to the store as a stream of their own.
  *
  *   - `words`: as [[Framer]] delivers them: `opcode << 8 | length`, then the payload. Opcodes and lengths are not
  *     checked again.
  *   - `job`: a filled bank; waits until the rasterizer takes it. Banks alternate; `jobDone` pulses when the oldest
  *     job's bank is free again. `begin` waits for a free bank, `texels` until every job is done.
  *   - a refused command changes nothing, but for texels that run beyond the memory, of which those within it are
  *     written, and for `begin`, which ends the frame begun before it in any case
  *   - hardware built for fewer states, clear colours, vertices or triangles, or for narrower ranges, refuses the
  *     others
  *   - a refused vertex leaves its slot with a tag of another frame; a position out of range is not stored
  *   - a triangle is refused that names a vertex or a state not sent in this frame: states are not kept from frame to
  *     frame
  *   - a triangle costs about 55 cycles, a vertex 31
  */
case class CommandDecoder(config: RasterConfig) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val words = slave(Stream(Bits(16 bits)))
    val store = master(StoreBus(layout))
    val texels = master(Stream(TexelWrite()))
    val job = master(Stream(FrameJob(config)))
    val jobDone = in Bool ()
    val drawing = out Bool ()
    val events = out(DecoderEvents())
  }

  val reader = CommandReader()
  val begin = BeginCommand(config)
  val states = SentStates()
  val state = StateCommand(config)
  val vertices = VertexCommand(config)
  val vertexStore = VertexStore(config)
  val triangles = TriangleCommand(config)
  val texels = TexelCommand(config)
  val draw = DrawCommand(config)

  reader.io.words << io.words
  reader.io.open := begin.io.open
  reader.io.turn := triangles.io.turn
  val units = Seq(
    Command.Begin -> begin.io.up,
    Command.State -> state.io.up,
    Command.Vertices -> vertices.io.up,
    Command.Triangles -> triangles.io.up,
    Command.Texels -> texels.io.up,
    Command.Draw -> draw.io.up
  )
  private def isMine(command: Command) = reader.io.opcode === command.opcode
  for ((command, up) <- units) {
    up.group.valid := reader.io.group.valid && isMine(command)
    up.group.payload := reader.io.group.payload
  }
  reader.io.group.ready := units.map { case (command, up) => isMine(command) && up.group.ready }.orR
  reader.io.refuse := units.map { case (command, up) => isMine(command) && up.refuse }.orR

  // Of the frame.
  begin.io.free := draw.io.free
  begin.io.drawn := io.job.fire
  states.io.fresh := begin.io.fresh
  vertices.io.fresh := begin.io.fresh
  triangles.io.fresh := begin.io.fresh
  triangles.io.tag := begin.io.tag
  draw.io.vertices := vertices.io.arrived
  draw.io.triangles := triangles.io.arrived
  draw.io.jobDone := io.jobDone
  io.drawing := draw.io.drawing
  texels.io.drawing := draw.io.drawing
  io.texels << texels.io.texels
  io.job.arbitrationFrom(draw.io.job)
  io.job.bank := draw.io.bank
  io.job.triangleCount := triangles.io.stored
  io.job.clearColor := begin.io.clearColor
  for ((end, tile) <- Seq(io.job.x0, io.job.x1, io.job.y0, io.job.y1).zip(begin.io.region)) end := tile

  // Render states.
  states.io.named.valid := reader.io.group.valid && reader.io.group.first
  states.io.named.payload := reader.io.group.single
  states.io.sends := state.io.sends
  state.io.index := states.io.index
  state.io.missing := states.io.missing
  state.io.found := states.io.found
  triangles.io.index := states.io.index
  triangles.io.missing := states.io.missing
  triangles.io.sent := states.io.sent

  // Vertices.
  vertices.io.passing.valid := reader.io.passing.valid && isMine(Command.Vertices) && !reader.io.group.first
  vertices.io.passing.payload := reader.io.passing.payload
  vertexStore.io.tag := begin.io.tag
  vertexStore.io.up << vertices.io.down

  val port = StorePort(layout)
  val writer = Mux(isMine(Command.Triangles), U(2), Mux(isMine(Command.Vertices), U(1, 2 bits), U(0, 2 bits)))
  port.io.write << StreamMux(writer, Seq(state.io.writes, vertexStore.io.writes, triangles.io.writes))
  port.io.read << triangles.io.reads
  port.io.bank := draw.io.bank
  port.io.store <> io.store
  triangles.io.answer := io.store.rsp

  io.events.accepted := reader.io.accepted
  io.events.refused := reader.io.refused
  io.events.vertexRefused := vertices.io.refused
  io.events.triangleRefused := triangles.io.refused
  io.events.incomplete := draw.io.incomplete
}

object CommandDecoder {

  /** Vertices and triangles that arrive are counted modulo 4096 and compared with the counts of `draw`. */
  val CountBits = 12
}
