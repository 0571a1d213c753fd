package frustum.fit

import frustum.contract.raster.{FixedState, RasterConfig}
import frustum.driver.raster.{DrawOptions, StateTable, TextureMemory}
import frustum.driver.scene.Scene

/** What a scene needs by inspection: no view is drawn for it.
  *
  * @param config  nothing in it but what the scene's states can choose, vertices no farther than they reach from the
  *                volume's views, texel memory and store of the sizes that it fills
  * @param options back faces are culled, and there is no depth test, where nothing can hide anything else
  */
final case class FitFeatures(config: RasterConfig, options: DrawOptions)

object FitFeatures {
  def apply(
      scene: Scene,
      base: RasterConfig,
      options: DrawOptions,
      volume: CameraVolume = CameraVolume.default
  ): FitFeatures = {
    val lone = Convexity.of(scene)
    val drawn =
      options.copy(cullBack = options.cullBack || lone.contains(Convexity.Solid), depthTest = lone.isEmpty)
    val memory = TextureMemory.allocate(scene, base)
    val states = StateTable(scene, memory, drawn).states
    val texels = memory.uploads.map(u => u.base * TextureMemory.Unit + u.texels.length).maxOption.getOrElse(0)
    val bounds = SceneBounds(scene, volume, base.width, base.height, drawn)
    def store(needed: Int, most: Int) = if (bounds.whole) powerOfTwo(needed, 4).min(most) else most
    val config = base.copy(
      textureTexels = powerOfTwo(texels, 64),
      fixed = FixedState.of(states: _*),
      ranges = bounds.ranges,
      maxVertices = store(bounds.vertices, base.maxVertices),
      maxTriangles = store(bounds.triangles, base.maxTriangles),
      clearColor = Some(TextureMemory.rgb565(drawn.background))
    )
    FitFeatures(config, drawn)
  }

  private def powerOfTwo(needed: Int, least: Int) = Iterator.iterate(least)(_ * 2).find(_ >= needed).get
}
