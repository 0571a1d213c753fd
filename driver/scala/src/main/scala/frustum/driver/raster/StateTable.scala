package frustum.driver.raster

import frustum.contract.InputError
import frustum.contract.raster.{Combine, DepthFunction, RenderState}
import frustum.driver.scene.{Material, Scene}

/** The render states of a scene's materials; equal ones share an entry of the hardware's table. */
final case class StateTable(states: IndexedSeq[RenderState], ofMaterial: IndexedSeq[Int]) {
  def apply(material: Int): RenderState = states(ofMaterial(material))
}

object StateTable {

  /** InputError when the scene needs more than [[RenderState.Count]] states. */
  def apply(scene: Scene, textures: TextureMemory, options: DrawOptions): StateTable = {
    val used = scene.triangles.iterator.map(_.material).toSet
    val each = scene.materials.indices.map { i =>
      if (used(i)) state(scene.materials(i), textures, options) else RenderState()
    }
    val states = scene.materials.indices.filter(used).map(each).distinct
    if (states.length > RenderState.Count)
      throw InputError(
        s"${scene.place}: the materials need ${states.length} render states, " +
          s"the hardware holds ${RenderState.Count}; let materials share textures and blending"
      )
    StateTable(states, each.map(states.indexOf(_)))
  }

  /** What is blended does not write depth: whatever lies behind has been drawn already, and panes may
    * intersect.
    */
  private def state(m: Material, textures: TextureMemory, options: DrawOptions): RenderState = {
    // Replace would hide the light, which is in the vertex colour
    val combine = if (m.combine == Combine.Replace && options.light.isDefined) Combine.Modulate else m.combine
    RenderState(
      texture = m.texture.map(textures.references),
      wrapS = m.wrap.getOrElse(options.wrap),
      wrapT = m.wrap.getOrElse(options.wrap),
      combine = if (m.texture.isEmpty) Combine.ColorOnly else combine,
      depth = if (options.depthTest) DepthFunction.Less else DepthFunction.Always,
      depthWrite = options.depthTest && !m.blend,
      blend = m.blend,
      alphaRef = m.alphaTest.fold(0)(a => (a * 31).round.toInt.max(1).min(31))
    )
  }
}
