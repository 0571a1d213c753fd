package frustum.model.raster

/** Told of every covered pixel that enters the fragment stages, whatever comes of it. `texelS`, `texelT` are the texel
  * that is read, after wrapping; `depth` is 0..65535; `drawn` when it passes the tests of its alpha and depth.
  */
trait FragmentProbe {
  def fragment(triangle: Int, x: Int, y: Int, texelS: Int, texelT: Int, depth: Int, drawn: Boolean): Unit
}
