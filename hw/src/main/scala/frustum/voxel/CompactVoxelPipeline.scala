package frustum.voxel

import frustum.contract.voxel.{VoxelAssets, VoxelCamera, VoxelConfig}
import frustum.device.Tech
import frustum.voxel.compact.{CompactComposite, CompactRays, CompactTexel}
import frustum.voxel.march.{CameraMemory, CameraWrite, FacePicker, Marcher, MarcherStages, PixelOrder, PointedAt}
import frustum.voxel.world.{SharedWorldMemory, WorldWrite}
import spinal.core._
import spinal.lib._

/** [[VoxelPipeline]] for a small FPGA: the same pictures, pixels in order, RGB565, without a frame buffer. Rays march
  * four at a time, one step per cycle. Work per ray, face or layer uses 9 to 17 cycles and one or two multipliers per
  * unit.
  * {{{
  * SerialRays -> Marcher <-> SharedWorldMemory
  *                  Marcher -> SerialTexel -> SerialComposite -> PixelOrder -> pixels
  * }}}
  * `start` is taken while not `busy` and a frame is drawn with the newest complete camera. Edits wait until a frame is
  * drawn; if there are more than [[CompactVoxelPipeline.Patient]], a world is being loaded, and they are made at once.
  *
  * @param camera initial camera
  */
case class CompactVoxelPipeline(
    config: VoxelConfig,
    assets: VoxelAssets,
    camera: VoxelCamera,
    tech: Tech = Tech.Generic,
    reach: Int = VoxelConfig.Reach
) extends Component {
  import CompactVoxelPipeline._
  fault(config).foreach(fault => throw new IllegalArgumentException(fault))
  val io = new Bundle {
    val start = in Bool ()
    val highlight = in Bool ()
    val camera = slave(Flow(CameraWrite()))
    val commit = in Bool ()
    val edit = slave(Stream(WorldWrite(config)))
    val busy = out Bool ()
    val pending = out Bool () // edits are waiting
    val pixels = master(Stream(Bits(16 bits)))
    val pointedAt = out(PointedAt(config))
    val step = out Bool ()
  }
  private val stages = MarcherStages.Compact
  val cameras = CameraMemory(config, camera)
  val rays = CompactRays(config, tech)
  val marcher = Marcher(config, assets.table, tech, stages)
  val memory = SharedWorldMemory(config, tech)
  val texels = CompactTexel(config, stages.slots, tech)
  val composite = CompactComposite(config, assets.table, assets.textures, stages.slots, tech)
  val order = PixelOrder()

  val starting = io.start && !io.busy
  cameras.io.write << io.camera
  cameras.io.commit := io.commit
  cameras.io.take := starting
  cameras.io.index := rays.io.index
  cameras.io.axis := texels.io.axis
  rays.io.value := cameras.io.value
  texels.io.eye := cameras.io.eye
  rays.io.start := starting

  rays.io.down >> marcher.io.up
  marcher.io.memory <> memory.io.read
  marcher.io.granted := memory.io.granted
  marcher.io.accepted := texels.io.up.ready
  texels.io.up.valid := marcher.io.hits.valid
  texels.io.up.payload := marcher.io.hits.payload
  texels.io.down >> composite.io.up
  composite.io.down >> order.io.up
  order.io.next := rays.io.pixel
  rays.io.room := order.io.room
  order.io.down >> io.pixels
  io.step := marcher.io.step

  val edits = new Area {
    val queue = StreamFifo(WorldWrite(config), Edits)
    queue.io.push << io.edit
    io.pending := queue.io.pop.valid
    val now = !io.busy || queue.io.occupancy > Patient
    memory.io.write << queue.io.pop.continueWhen(now).toFlow
  }

  val pick = FacePicker(config, assets.table, stages.slots, reach)
  pick.io.start := rays.io.start
  pick.io.hits << texels.io.down.toFlowFire
  rays.io.picked := pick.io.picked
  io.pointedAt := pick.io.found
  composite.io.pointedAt := pick.io.found
  composite.io.pointedAt.valid.removeAssignments() := pick.io.found.valid && io.highlight

  val drawing = new Area {
    val rayCount = RegInit(U(0, 4 bits)) // rays begun and not done
    when(rays.io.begun =/= composite.io.done)(rayCount := Mux(rays.io.begun, rayCount + 1, rayCount - 1))
    io.busy := rays.io.busy || rayCount =/= 0
  }
}

object CompactVoxelPipeline {

  /** The rule that a configuration breaks, with the remedy, or None. */
  def fault(config: VoxelConfig): Option[String] =
    if (config.leaps.wordBits > 8)
      Some(s"two words of leaps of ${config.leaps.wordBits} bits do not fit into 16 bits; use up-down")
    else if (config.farSquared - config.fogSquared >= (1 << 16))
      Some(s"a view distance of ${config.distance} is too far for a multiplier of 16 bits; at most 24")
    else None

  /** Edits that wait while a frame is drawn, and how many of them wait for the frame's end. */
  val Edits = 256
  val Patient = 128
}
