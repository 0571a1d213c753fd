package frustum.voxel.wide

import frustum.contract.voxel.VoxelConfig
import frustum.voxel.march.{CameraPort, Direction, PixelRay}
import spinal.core._
import spinal.lib._

/** Directions of a frame's rays: first that of the screen's middle, by which the block pointed at is found, and when
  * `picked` says that it is, those of the pixels, row by row from the top. One a clock; nothing is multiplied.
  *
  * `start` is taken while not `busy`; the camera must hold until `busy` falls.
  */
case class PixelRays(c: VoxelConfig) extends Component {
  val io = new Bundle {
    val start = in Bool ()
    val picked = in Bool ()
    val camera = in(CameraPort(c))
    val down = master(Stream(PixelRay(c)))
    val busy = out Bool ()
  }
  val picking, waiting, scanning = RegInit(False)
  val pixel = Reg(UInt(c.pixelBits bits))
  val column = Reg(UInt(log2Up(c.width) bits))
  val row, now = Reg(Direction())

  io.busy := picking || waiting || scanning
  io.down.valid := picking || scanning
  io.down.pick := picking
  io.down.pixel := pixel
  io.down.direction := now

  when(io.start && !io.busy) {
    picking := True
    now := io.camera.look
  }
  when(picking && io.down.ready) {
    picking := False
    waiting := True
  }
  when(waiting && io.picked) {
    waiting := False
    scanning := True
    pixel := 0
    column := 0
    row := io.camera.base
    now := io.camera.base
  }
  when(scanning && io.down.ready) {
    pixel := pixel + 1
    column := column + 1
    for (k <- 0 to 2) now.axes(k) := now.axes(k) + io.camera.right.axes(k)
    when(column === c.width - 1) {
      column := 0
      for (k <- 0 to 2) {
        val next = row.axes(k) + io.camera.down.axes(k)
        row.axes(k) := next
        now.axes(k) := next
      }
    }
    when(pixel === c.pixels - 1)(scanning := False)
  }
}
