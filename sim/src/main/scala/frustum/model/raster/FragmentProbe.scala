package frustum.model.raster

/** Told of every covered pixel that enters the fragment stages, before any test of its depth or alpha.
  * `texelS`, `texelT` are the texel that is read, after wrapping; `depth` is 0..65535.
  */
trait FragmentProbe {
  def fragment(triangle: Int, x: Int, y: Int, texelS: Int, texelT: Int, depth: Int): Unit
}
