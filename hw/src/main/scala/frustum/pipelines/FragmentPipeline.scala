package frustum.pipelines

import frustum.blackbox.Tech
import frustum.fragment._
import frustum.frame._
import frustum.raster.{InterpolatedFragment, RenderStateWord}
import frustum.spec.RasterConfig
import frustum.texture._
import spinal.core._
import spinal.lib._

/** From interpolated fragments to finished pixels, tile by tile; one fragment a clock.
  *
  * While a fragment's coordinate is divided and its texel fetched, its other attributes wait in a memory.
  *
  *   - `start` comes before the first fragment of each frame or pass and is taken when the tile memories are
  *     clear
  *   - `tile` tells the position of each tile, in the order of their end marks
  *   - `state` must be stable from when a fragment is taken until `busy` is low; it rises the clock after
  *   - `texels` writes texel memory; each write costs the fragments a clock
  */
case class FragmentPipeline(config: RasterConfig, tech: Tech) extends Component {
  val io = new Bundle {
    val up = slave(Stream(InterpolatedFragment(config)))
    val state = in(RenderStateWord())
    val busy = out Bool ()
    val start = slave(Stream(FrameStart()))
    val tile = slave(Stream(TilePosition()))
    val texels = slave(Stream(TexelWrite()))
    val pixels = master(Stream(ResolvedPixel(config)))
  }

  val divide = PerspectiveDivide(tech)
  val texture = TextureUnit(config, tech)
  val waiting = StreamFifo(FragmentAttributes(config), FragmentPipeline.InFlight)
  val combine = Combine(config, tech)
  val alpha = AlphaTest(config)
  val lock = Interlock(config)
  val depth = DepthTest(config)
  val blend = Blend(config)
  val resolver = Resolver(config)

  val (coordinates, attributes) = StreamFork2(io.up, synchronous = true)
  divide.io.up << coordinates.translateWith {
    val coordinate = ProjectiveCoordinate()
    coordinate.assignSomeByName(coordinates.payload.asInstanceOf[Bundle])
    coordinate
  }
  texture.io.up << divide.io.down
  waiting.io.push << attributes.translateWith(FragmentAttributes(config, attributes.payload))

  // The memory shows a fragment after 2 clocks, long before its texel comes, so the texel alone says when to go
  // on. A join that made the texel wait for valid would stop the bubbles of the divide.
  val texel = texture.io.down
  assert(!texel.valid || waiting.io.pop.valid, "a texel has overtaken its fragment")
  waiting.io.pop.ready := texel.fire
  texel.ready := combine.io.up.ready
  combine.io.up.valid := texel.valid
  combine.io.up.payload.attributes := waiting.io.pop.payload
  combine.io.up.payload.texel := texel.payload

  alpha.io.up << combine.io.down
  lock.io.up << alpha.io.down
  depth.io.up << lock.io.down
  blend.io.up << depth.io.down

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

  val inFlight =
    waiting.io.occupancy =/= 0 || combine.io.busy || lock.io.busy || depth.io.busy || blend.io.busy
  io.busy := RegNext(io.up.fire || inFlight) init False
}

object FragmentPipeline {

  /** Room for the fragments between the perspective divide and the texel: nine, and a power of two. */
  val InFlight = 16
}
