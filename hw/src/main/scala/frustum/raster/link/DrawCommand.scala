package frustum.raster.link

import frustum.contract.raster.RasterConfig
import spinal.core._
import spinal.lib._

/** Executes `draw`: compares what was sent with what arrived and starts the rasterizer on the frame. Banks alternate;
  * at most two jobs are not yet done, as many as there are banks.
  */
case class DrawCommand(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(GroupPort())
    val vertices, triangles = in UInt (CommandDecoder.CountBits bits) // counts of what arrived
    val job = master(Stream(NoData()))
    val jobDone = in Bool ()
    val bank = out(RegInit(U(0, 1 bits)))
    val free = out Bool () // a bank is free
    val drawing = out Bool ()
    val incomplete = out Bool ()
  }
  val group = io.up.group
  val jobs = RegInit(U(0, 2 bits)) // jobs that are not done
  jobs := jobs + U(io.job.fire) - U(io.jobDone)
  io.drawing := jobs =/= 0
  io.free := !jobs.msb

  // Vertices come first.
  val arrived = Mux(group.first, io.vertices, io.triangles)
  val differs = RegNext(group.single.asUInt =/= arrived.resize(16))
  val missing = Reg(Bool()) // the number of vertices differs
  when(group.valid && group.first)(missing := differs)

  io.job.valid := group.valid && !group.first
  group.ready := group.first || io.job.ready
  io.up.refuse := False
  io.incomplete := io.job.fire && (missing || differs)
  when(io.job.fire)(io.bank := ~io.bank)
}
