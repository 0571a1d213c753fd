package frustum.scene

import frustum.driver.scene.TextureImage

/** The textures of our scenes, drawn in code. A picture is a function of texel column and row, from the top
  * left.
  */
object Pictures {
  type Rgb = (Double, Double, Double)

  def opaque(width: Int, height: Int)(f: (Int, Int) => Rgb): TextureImage =
    TextureImage(
      width,
      height,
      for (y <- 0 until height; x <- 0 until width) yield 0xff000000 | rgb(f(x, y)),
      hasAlpha = false
    )

  /** With alpha 0..1 beside the colour. */
  def translucent(width: Int, height: Int)(f: (Int, Int) => (Rgb, Double)): TextureImage =
    TextureImage(
      width,
      height,
      for (y <- 0 until height; x <- 0 until width) yield { val (c, a) = f(x, y); byte(a) << 24 | rgb(c) },
      hasAlpha = true
    )

  /** A wooden crate: planks, a frame round them and a brace across, with nails. */
  def crate: TextureImage = opaque(64, 64) { (x, y) =>
    val edge = Seq(x, y, 63 - x, 63 - y).min
    val brace = (x - y).abs
    val wood: Rgb = (0.78, 0.56, 0.32)
    val nail =
      (Seq(4, 59).contains(x) || Seq(4, 59).contains(y)) && (x + y) % 11 == 8 && edge >= 3 && edge <= 5
    if (nail) (0.25, 0.22, 0.2)
    else if (edge < 8) shade(wood, (if (edge == 0 || edge == 7) 0.55 else 0.95) + 0.15 * noise(x / 5, y, 1))
    else if (brace < 7) shade(wood, (if (brace == 6) 0.5 else 0.85) + 0.15 * noise(x + y, x - y, 2))
    else shade(wood, (if (x % 12 == 8) 0.35 else 0.58) + 0.15 * noise(x, y / 7, 3))
  }

  /** Eight by eight fields in alternating colours that change across the texture, each with a light upper
    * left and a dark lower right texel: a texel fetched one off shows.
    */
  def checker: TextureImage = opaque(64, 64) { (x, y) =>
    val base: Rgb =
      if ((x / 8 + y / 8) % 2 == 0) (0.95, 0.3 + 0.6 * x / 63, 0.15) else (0.08, 0.2 + 0.3 * y / 63, 0.55)
    (x % 8, y % 8) match {
      case (0, 0) => (1, 1, 1)
      case (7, 7) => (0, 0, 0)
      case (i, j) => shade(base, 1 - 0.02 * (i + j))
    }
  }

  /** Bricks in stretcher bond. */
  def bricks: TextureImage = opaque(64, 64) { (x, y) =>
    val course = y / 8
    val along = (x + (if (course % 2 == 0) 0 else 8)) % 64
    val tint = 0.75 + 0.3 * noise(along / 16, course, 4) + 0.12 * noise(x, y, 5)
    if (y % 8 == 7 || along % 16 == 15) shade((0.62, 0.6, 0.56), 0.85 + 0.15 * noise(x, y, 6))
    else shade((0.68, 0.33, 0.24), if (y % 8 == 0 || along % 16 == 0) tint * 1.15 else tint)
  }

  /** Stone slabs, four to a repeat. */
  def slabs: TextureImage = opaque(64, 64) { (x, y) =>
    val tint = 0.7 + 0.25 * noise(x / 32, y / 32, 7) + 0.14 * noise(x, y, 8)
    if (x % 32 == 31 || y % 32 == 31) (0.16, 0.16, 0.18)
    else shade((0.62, 0.64, 0.68), if (x % 32 == 0 || y % 32 == 0) tint * 1.2 else tint)
  }

  /** Diagonal bars with holes between them. */
  def grille: TextureImage = translucent(32, 32) { (x, y) =>
    val bar = scala.math.min((x + y) % 16, (x - y + 32) % 16)
    (if (bar <= 1) (0.95, 0.93, 0.85) else (0.6, 0.56, 0.45), if (bar <= 3) 1.0 else 0.0)
  }

  /** Light grain, to be modulated. */
  def grain: TextureImage = opaque(64, 64) { (x, y) =>
    val g = 0.72 + 0.16 * noise(x, y, 9) + 0.1 * noise(x / 2, y / 2, 10) + 0.06 * noise(x / 8, y / 8, 11)
    (g, g, g)
  }

  def shade(c: Rgb, f: Double): Rgb = (c._1 * f, c._2 * f, c._3 * f)

  /** A number in 0..1 that looks random, the same on every machine: an integer hash (the finaliser of
    * MurmurHash3).
    */
  def noise(x: Int, y: Int, seed: Int): Double = {
    var h = x * 0x8da6b343 + y * 0xd8163841 + seed * 0xcb1ab31f
    h = (h ^ (h >>> 16)) * 0x85ebca6b
    h = (h ^ (h >>> 13)) * 0xc2b2ae35
    ((h ^ (h >>> 16)) >>> 8) / 16777216.0
  }

  private def byte(v: Double): Int = (v * 255).round.toInt.max(0).min(255)
  private def rgb(c: Rgb): Int = byte(c._1) << 16 | byte(c._2) << 8 | byte(c._3)
}
