package frustum.raster

import frustum.contract.raster.RasterConfig
import frustum.device.Tech
import frustum.raster.fragment.{AlphaStage, AttributeMemory, Blend, Combine, DepthStage, Interlock}
import frustum.raster.scan.InterpolatedFragment
import frustum.raster.store.RenderStateWord
import frustum.raster.texture.{LateDivide, PerspectiveDivide, ProjectiveCoordinate, TexelWrite, TextureUnit}
import frustum.raster.tile.{FrameStart, Resolver, TilePosition}
import frustum.video.ResolvedPixel
import spinal.core._
import spinal.lib._

/** From interpolated fragments to finished pixels, tile by tile; one fragment per cycle.
  *
  * While a fragment's coordinate is divided and its texel fetched, its other attributes are kept in a memory.
  *
  *   - `start` comes before the first fragment of each frame or pass and is taken when the tile memories are
  *     clear
  *   - `tile` has the position of each tile, in the order of the tile-end markers
  *   - `state` must be stable from when a fragment is taken until `busy` is low; it rises a cycle later
  *   - `texels` writes texel memory; each write costs the fragments a cycle
  */
case class FragmentPipeline(config: RasterConfig, tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val up = slave(Stream(InterpolatedFragment(config)))
    val state = in(RenderStateWord())
    val busy = out Bool ()
    val start = slave(Stream(FrameStart()))
    val tile = slave(Stream(TilePosition()))
    val texels = slave(Stream(TexelWrite()))
    val pixels = master(Stream(ResolvedPixel(config)))
  }

  private val isLate = LateDivide.suits(config)
  val lateDivide = isLate generate LateDivide(config, tech)
  val divide = !isLate generate PerspectiveDivide(tech)
  private def divideIo = if (isLate) lateDivide.io else divide.io
  val texture = TextureUnit(config, tech)
  val waiting = AttributeMemory(config)
  val combine = Combine(config, tech)
  val lock = Interlock(config)
  val alpha = AlphaStage(config)
  val depth = DepthStage(config)
  val blend = Blend(config, tech)
  val resolver = Resolver(config)

  divideIo.up << io.up.translateWith {
    val coordinate = ProjectiveCoordinate()
    coordinate.assignSomeByName(io.up.payload.asInstanceOf[Bundle])
    coordinate
  }
  texture.io.up << divideIo.down
  waiting.io.push << io.up.toFlowFire
  waiting.io.fetch := texture.io.fetch

  combine.io.up.arbitrationFrom(texture.io.down)
  combine.io.up.payload.attributes := waiting.io.attributes
  combine.io.up.payload.texel := texture.io.down.payload

  lock.io.up << combine.io.down
  waiting.io.fetchDepth := lock.io.down.valid
  alpha.io.up << lock.io.down
  depth.io.up << alpha.io.down
  depth.io.z := waiting.io.z
  blend.io.up << depth.io.down
  blend.io.passed := depth.io.passed

  for (
    state <- Seq(
      texture.io.state,
      combine.io.state,
      alpha.io.state,
      lock.io.state,
      depth.io.state,
      blend.io.state
    )
  )
    state := io.state
  texture.io.texels << io.texels

  resolver.io.start << io.start
  resolver.io.tile << io.tile
  resolver.io.tileEnd << blend.io.tileEnd
  resolver.io.drawing := io.busy
  resolver.io.color := blend.io.color
  blend.io.clearColor := resolver.io.clearColor
  for (clear <- Seq(lock.io.clear, depth.io.clear, blend.io.clear)) clear.assignAllByName(resolver.io.clear)
  io.pixels << resolver.io.pixels

  val inFlight = !waiting.io.empty || depth.io.busy || blend.io.busy
  io.busy := RegNext(io.up.fire || inFlight) init False
}
