package frustum.voxel.march

import frustum.contract.voxel.{BlockTable, VoxelConfig}
import frustum.voxel.world.BlockFlags
import spinal.core._
import spinal.lib._

/** Keeps the first face of a selectable block within reach that the ray which picks meets, from `start` on, and reports
  * when that ray has ended.
  *
  * @param reach blocks
  */
case class FacePicker(config: VoxelConfig, kinds: BlockTable, slots: Int, reach: Int) extends Component {
  val io = new Bundle {
    val start = in Bool ()
    val hits = slave(Flow(TexelHit(config, slots)))
    val picked = out(Bool())
    val found = out(PointedAt(config))
  }
  val hit = io.hits
  val selectable = BlockFlags(kinds).where(_.selectable)(hit.id)
  val found = Reg(PointedAt(config))
  found.valid init False
  when(io.start)(found.valid := False)
  when(hit.valid && hit.pick && hit.shown && selectable && !found.valid && hit.far <= 256 * reach * reach) {
    found.valid := True
    found.block := hit.block
    found.face := hit.face
  }
  io.found := found
  io.picked := RegNext(hit.valid && hit.pick && hit.last, False)
}
