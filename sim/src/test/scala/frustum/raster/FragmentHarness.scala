package frustum.raster

import frustum.contract.raster.RasterConfig
import frustum.device.Tech
import frustum.raster.scan.InterpolatedFragment
import frustum.raster.store.RenderStateWord
import frustum.raster.texture.TexelWrite
import frustum.raster.tile.{FrameStart, TilePosition}
import frustum.video.ResolvedPixel
import spinal.core._
import spinal.lib._

/** The fragment pipeline as its sender uses it: the fragments of each frame wait until its `start` was taken.
  */
class FragmentHarness(config: RasterConfig, tech: Tech = Tech.Generic) extends Component {
  val io = new Bundle {
    val up = slave(Stream(InterpolatedFragment(config)))
    val state = in(RenderStateWord())
    val start = slave(Stream(FrameStart()))
    val tile = slave(Stream(TilePosition()))
    val texels = slave(Stream(TexelWrite()))
    val pixels = master(Stream(ResolvedPixel(config)))
    val busy = out Bool ()
  }
  val pipeline = FragmentPipeline(config, tech)
  val started = RegInit(False) setWhen pipeline.io.start.fire
  val tiles = Counter(config.tilesX * config.tilesY, inc = pipeline.io.up.fire && pipeline.io.up.tileEnd)
  when(tiles.willOverflow) { started := False }
  pipeline.io.start << io.start.haltWhen(started)
  pipeline.io.up << io.up.haltWhen(!started)
  pipeline.io.state := io.state
  pipeline.io.tile << io.tile
  pipeline.io.texels << io.texels
  io.pixels << pipeline.io.pixels
  io.busy := pipeline.io.busy
}
