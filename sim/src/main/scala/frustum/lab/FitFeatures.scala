package frustum.lab

import frustum.host.{DrawOptions, StateTable, TextureMemory}
import frustum.scene.Scene
import frustum.spec.{FixedState, RasterConfig}

/** What a scene needs by inspection: no view is drawn for it.
  *
  * @param config  nothing in it but what the scene's states can choose, and texel memory of the size it fills
  * @param options back faces are culled, and there is no depth test, where nothing can hide anything else
  */
final case class FitFeatures(config: RasterConfig, options: DrawOptions)

object FitFeatures {
  def apply(scene: Scene, base: RasterConfig, options: DrawOptions): FitFeatures = {
    val lone  = Convexity.of(scene)
    val drawn =
      options.copy(cullBack = options.cullBack || lone.contains(Convexity.Solid), depthTest = lone.isEmpty)
    val memory = TextureMemory.allocate(scene, base)
    val states = StateTable(scene, memory, drawn).states
    val texels = memory.uploads.map(u => u.base * TextureMemory.Unit + u.texels.length).maxOption.getOrElse(0)
    val rounded = Iterator.iterate(64)(_ * 2).find(_ >= texels).get
    FitFeatures(base.copy(textureTexels = rounded, fixed = FixedState.of(states: _*)), drawn)
  }
}
