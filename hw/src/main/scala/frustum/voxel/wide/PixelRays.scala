package frustum.voxel.wide

import frustum.contract.voxel.VoxelConfig
import frustum.voxel.march.{CameraPort, Direction, PixelRay}
import spinal.core._
import spinal.lib._
import spinal.lib.fsm._

/** Directions of a frame's rays: first that of the screen's middle, which selects a block, and when that is done
  * (`picked`), those of the pixels, row by row from the top. One per cycle, without multipliers.
  *
  * `start` is taken while not `busy`; the camera must hold until `busy` falls.
  */
case class PixelRays(config: VoxelConfig) extends Component {
  val io = new Bundle {
    val start = in Bool ()
    val picked = in Bool ()
    val camera = in(CameraPort(config))
    val down = master(Stream(PixelRay(config)))
    val busy = out Bool ()
  }
  val pixel = Reg(UInt(config.pixelBits bits))
  val column = Reg(UInt(log2Up(config.width) bits))
  val row, now = Reg(Direction())

  val fsm = new StateMachine {
    val idle = makeInstantEntry()
    val pick, settle, scan = new State
    idle.whenIsActive {
      when(io.start) {
        now := io.camera.look
        goto(pick)
      }
    }
    pick.whenIsActive(when(io.down.ready)(goto(settle)))
    settle.whenIsActive {
      when(io.picked) {
        pixel := 0
        column := 0
        row := io.camera.base
        now := io.camera.base
        goto(scan)
      }
    }
    scan.whenIsActive {
      when(io.down.ready) {
        pixel := pixel + 1
        column := column + 1
        for (k <- 0 to 2) now.axes(k) := now.axes(k) + io.camera.right.axes(k)
        when(column === config.width - 1) {
          column := 0
          for (k <- 0 to 2) {
            val next = row.axes(k) + io.camera.down.axes(k)
            row.axes(k) := next
            now.axes(k) := next
          }
        }
        when(pixel === config.pixels - 1)(goto(idle))
      }
    }
  }
  io.busy := !fsm.isActive(fsm.idle)
  io.down.pick := fsm.isActive(fsm.pick)
  io.down.valid := fsm.isActive(fsm.pick) || fsm.isActive(fsm.scan)
  io.down.pixel := pixel
  io.down.direction := now
}
