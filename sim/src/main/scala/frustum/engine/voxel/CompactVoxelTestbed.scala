package frustum.engine.voxel

import frustum.contract.voxel.{VoxelAssets, VoxelCamera, VoxelConfig}
import frustum.device.Tech
import frustum.voxel.CompactVoxelPipeline
import frustum.voxel.march.{CameraWrite, PointedAt}
import frustum.voxel.world.WorldWrite
import spinal.core._
import spinal.lib._

/** The small voxel pipeline with a picture to draw into and counters, so that the JVM need not be woken while it draws.
  *
  * `pace`: clocks after a pixel until the next is taken, as a display's; with `stalls` twice as many now and then.
  */
case class CompactVoxelTestbed(c: VoxelConfig, assets: VoxelAssets) extends Component {
  val io = new Bundle {
    val start = in Bool ()
    val highlight = in Bool ()
    val camera = slave(Flow(CameraWrite()))
    val commit = in Bool ()
    val edit = slave(Stream(WorldWrite(c)))
    val pace = in UInt (6 bits)
    val stalls = in Bool ()
    val busy = out Bool ()
    val pointedAt = out(PointedAt(c))
    val clocks, steps, pixels =
      out(Reg(UInt(32 bits)) init 0) // since the start of the frame, until its last pixel is taken
  }
  val pipeline = CompactVoxelPipeline(c, assets, VoxelCamera.level(c, c.width max c.height), Tech.Generic)
  val picture = Mem(Bits(16 bits), c.pixels)

  pipeline.io.start := io.start
  pipeline.io.highlight := io.highlight
  pipeline.io.camera << io.camera
  pipeline.io.commit := io.commit
  pipeline.io.edit << io.edit
  io.pointedAt := pipeline.io.pointedAt

  val drawing = RegInit(False)
  val rest = RegInit(U(0, 6 bits))
  val random = Reg(Bits(16 bits)) init 1
  random := random(14 downto 0) ## (random(15) ^ random(13) ^ random(12) ^ random(10))
  io.busy := drawing || pipeline.io.busy

  val done = pipeline.io.pixels
  done.ready := rest === 0
  when(rest =/= 0)(rest := rest - 1)
  when(done.fire)(rest := Mux(random(2 downto 0) === 0 && io.stalls, io.pace |<< 1, io.pace))
  picture.write(io.pixels.resized, done.payload, done.fire)
  when(io.start && !io.busy) {
    drawing := True
    io.clocks := 0
    io.steps := 0
    io.pixels := 0
  } otherwise {
    when(io.busy)(io.clocks := io.clocks + 1)
    when(pipeline.io.step)(io.steps := io.steps + 1)
    when(done.fire) {
      io.pixels := io.pixels + 1
      when(io.pixels === c.pixels - 1)(drawing := False)
    }
  }
}
