package frustum.engine.voxel

import frustum.contract.voxel.{VoxelAssets, VoxelConfig}
import frustum.device.Tech
import frustum.voxel.march.{CameraPort, PointedAt}
import frustum.voxel.VoxelPipeline
import frustum.voxel.world.WorldWrite
import spinal.core._
import spinal.lib._

/** The voxel pipeline with a picture to draw into and counters, so that the JVM need not be woken while it draws. */
case class VoxelTestbed(c: VoxelConfig, assets: VoxelAssets) extends Component {
  val io = new Bundle {
    val start = in Bool ()
    val camera = in(CameraPort(c))
    val highlight = in Bool ()
    val edit = slave(Stream(WorldWrite(c)))
    val busy = out Bool ()
    val pointedAt = out(PointedAt(c))
    val clocks, steps, pixels = out(Reg(UInt(32 bits)) init 0) // since the start of the frame
  }
  val pipeline = VoxelPipeline(c, assets.table, assets.textures, Tech.Generic)
  val picture = Mem(Bits(24 bits), c.pixels)

  pipeline.io.start := io.start
  pipeline.io.camera := io.camera
  pipeline.io.highlight := io.highlight
  pipeline.io.edit << io.edit
  pipeline.io.look.address.assignDontCare()
  io.busy := pipeline.io.busy
  io.pointedAt := pipeline.io.pointedAt

  private val done = pipeline.io.pixels
  picture.write(done.pixel.resized, done.rgb(0) ## done.rgb(1) ## done.rgb(2), done.valid)
  when(io.start && !io.busy) {
    io.clocks := 0
    io.steps := 0
    io.pixels := 0
  } otherwise {
    when(io.busy)(io.clocks := io.clocks + 1)
    when(pipeline.io.step)(io.steps := io.steps + 1)
    when(done.valid)(io.pixels := io.pixels + 1)
  }
}
