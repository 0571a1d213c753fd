package frustum.voxel

import frustum.contract.voxel.{BlockTable, VoxelConfig, VoxelTextures}
import frustum.device.Tech
import frustum.voxel.march.{CameraPort, FacePicker, Marcher, MarcherStages, PointedAt, VoxelColor}
import frustum.voxel.wide.{FaceTexel, LayerComposite, PixelRays, VoxelRaySetup}
import frustum.voxel.world.{WorldMemory, WorldReadBus, WorldWrite}
import spinal.core._
import spinal.lib._

/** Pictures of a world of blocks, one word of the world's memory per cycle:
  * {{{
  * PixelRays -> RaySetup -> Marcher <-> WorldMemory
  *                             Marcher -> FaceTexel -> LayerComposite -> pixels in the order of completion
  * }}}
  * `start` is taken while not `busy` and a frame is drawn from the camera as it is then; edits wait until the frame is
  * drawn. Before the pixels the block in the screen's middle is found, which is highlighted if `highlight` is high.
  *
  * @param reach greatest distance of a block that can be selected
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
    val look = slave(WorldReadBus(config)) // reads of the host while not busy
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

  // Ready has no combinational path from the ring through the set-up.
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
