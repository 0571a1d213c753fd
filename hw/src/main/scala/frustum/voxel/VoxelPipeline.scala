package frustum.voxel

import frustum.contract.voxel.{BlockTable, VoxelConfig, VoxelTextures}
import frustum.device.Tech
import frustum.voxel.march.{CameraPort, FacePicker, Marcher, MarcherStages, PointedAt, VoxelColor}
import frustum.voxel.wide.{FaceTexel, LayerComposite, PixelRays, VoxelRaySetup}
import frustum.voxel.world.{WorldMemory, WorldReadBus, WorldWrite}
import spinal.core._
import spinal.lib._

/** Pictures of a world of blocks, a word of the world's memory a cycle:
  * {{{
  * PixelRays -> RaySetup -> Marcher <-> WorldMemory
  *                             Marcher -> FaceTexel -> LayerComposite -> pixels, as they are done
  * }}}
  * `start` is taken while not `busy` and a frame is drawn from the camera as it is then; edits wait until the frame is
  * drawn. Before the pixels the block in the screen's middle is found, which is drawn highlighted if `highlight` says
  * so.
  *
  * @param reach blocks that can be pointed at are at most this far away
  */
case class VoxelPipeline(
    config: VoxelConfig,
    kinds: BlockTable,
    textures: VoxelTextures,
    tech: Tech = Tech.Generic,
    reach: Int = VoxelConfig.Reach
) extends Component {
  val io = new Bundle {
    val start = in Bool ()
    val camera = in(CameraPort(config))
    val highlight = in Bool ()
    val edit = slave(Stream(WorldWrite(config)))
    val look = slave(WorldReadBus(config)) // while not busy
    val busy = out Bool ()
    val pixels = master(Flow(VoxelColor(config)))
    val pointedAt = out(PointedAt(config))
    val step = out Bool ()
  }
  val rays = PixelRays(config)
  val setup = VoxelRaySetup(config, tech)
  val marcher = Marcher(config, kinds, tech)
  val memory = WorldMemory(config)
  val texels = FaceTexel(config, MarcherStages.Fast.slots)
  val composite = LayerComposite(config, kinds, textures, MarcherStages.Fast.slots)

  val starting = io.start && !io.busy
  val camera = RegNextWhen(io.camera, starting)
  rays.io.start := RegNext(starting, False)
  rays.io.camera := camera
  setup.io.eye := camera.eye
  texels.io.eye := camera.eye

  // No way of ready leads from the ring through the set-up.
  rays.io.down.s2mPipe() >> setup.io.up
  setup.io.down.s2mPipe() >> marcher.io.up
  memory.io.read.address := Mux(io.busy, marcher.io.memory.address, io.look.address)
  marcher.io.memory.word := memory.io.read.word
  io.look.word := memory.io.read.word
  marcher.io.hits >> texels.io.up
  texels.io.down >> composite.io.up
  composite.io.down >> io.pixels
  io.step := marcher.io.step

  memory.io.write << io.edit.haltWhen(io.busy).toFlow.stage() // written before the first ray can read

  val pick = FacePicker(config, kinds, MarcherStages.Fast.slots, reach)
  pick.io.start := rays.io.start
  pick.io.hits << texels.io.down
  rays.io.picked := pick.io.picked
  io.pointedAt := pick.io.found
  composite.io.pointedAt := pick.io.found
  composite.io.pointedAt.valid.removeAssignments() := pick.io.found.valid && io.highlight

  val drawing = new Area {
    val busy = RegInit(False) setWhen io.start
    val left = Reg(UInt(config.pixelBits bits))
    when(starting)(left := config.pixels - 1)
    when(io.pixels.valid) {
      left := left - 1
      when(left === 0)(busy := False)
    }
    io.busy := busy
  }
}
