package frustum.model.raster.fragment

/** An interpolated fragment as the hardware's bundle carries it: bits as two's complement numbers, `r g b a`
  * of 16 bits, the rest of 32. Mutable, so that millions of pixels need no objects.
  */
final class Fragment {
  var x, y = 0
  var s, t, q, z = 0
  var r, g, b, a = 0
}

/** Fraction bits cut and values clamped, as on entry to the fragment stages. */
object Fragment {
  def depth(z: Int): Int = if (z >= 0) z >>> 15 else if ((z & (1 << 30)) != 0) 0 else 65535
  def channel(c: Int): Int = if (c >= 0) c >>> 7 else if ((c & (1 << 14)) != 0) 0 else 255
}
