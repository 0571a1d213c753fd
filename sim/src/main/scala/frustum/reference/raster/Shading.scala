package frustum.reference.raster

import frustum.contract.raster.{Combine, RenderState, TexelFormat, TextureRef}

/** Fragment colour and alpha test in double precision. */
object Shading {
  private def clamp(c: Double) = c.max(0).min(255)

  /** The texture that fragments of this state read; `ColorOnly` reads none. */
  def textureOf(state: RenderState): Option[TextureRef] =
    state.texture.filter(_ => state.combine != Combine.ColorOnly)

  /** Texel (already wrapped) that the fragment reads, or None without a texture. */
  def texelOf(state: RenderState, at: Attributes): Option[(Int, Int)] = textureOf(state).map { t =>
    (
      Sampler.wrap((at.s * t.width).floor.toLong, t.width, state.wrapS),
      Sampler.wrap((at.t * t.height).floor.toLong, t.height, state.wrapT)
    )
  }

  /** Combines vertex colour and texel by the texture environment (OpenGL 2.1, table 3.21): where the texture
    * has no alpha the fragment keeps the vertex's.
    */
  def color(state: RenderState, memory: Array[Int], at: Attributes, texel: Option[(Int, Int)]): Rgba = {
    val vertex = Rgba(clamp(at.r), clamp(at.g), clamp(at.b), clamp(at.a))
    (textureOf(state), texel) match {
      case (Some(texture), Some((s, t))) =>
        val c = Sampler.texel(memory, texture, s, t)
        val opaque = texture.format == TexelFormat.Rgb565
        if (state.combine == Combine.Replace) c.copy(a = if (opaque) vertex.a else c.a)
        else Rgba(
          c.r * vertex.r / 255,
          c.g * vertex.g / 255,
          c.b * vertex.b / 255,
          if (opaque) vertex.a else c.a * vertex.a / 255
        )
      case _ => vertex
    }
  }

  /** The alpha test compares alpha as a five-bit number, rounded to nearest. */
  def passesAlphaTest(state: RenderState, alpha: Double): Boolean =
    state.alphaRef == 0 || (alpha / 255 * 31).round >= state.alphaRef
}
