package frustum.demos.voxel

import frustum.contract.voxel.VoxelTextures

/** The 32 textures of the workbench's blocks, drawn by code: two ramps of colours each, and a shade from 0 to 1 in one
  * of them for each texel.
  */
object BlockArt {
  private val Side = VoxelTextures.Side

  /** @param second whether the texel is of the second ramp; @param shade of it */
  private final case class Dab(second: Boolean, shade: Double)

  private final case class Painting(name: String, first: Ramp, second: Ramp, dab: (Int, Int) => Dab)

  /** Eight shades of a colour, 0xRRGGBB at its brightest.
    *
    * @param contrast how much darker the darkest is
    */
  private final case class Ramp(rgb: Int, contrast: Double = 0.4, alpha: Int = 15) {
    def colors: Seq[Int] = (0 until 8).map { i =>
      val light = 1 - contrast * (7 - i) / 7
      Seq(
        16,
        8,
        0
      ).map(at => ((rgb >> at & 255) * light * 15 / 255).round.toInt).foldLeft(0)(_ << 4 | _) << 4 | alpha
    }
  }

  /** Of one ramp alone. */
  private def single(name: String, ramp: Ramp)(shade: (Int, Int) => Double) =
    Painting(name, ramp, Clear, (u, v) => Dab(second = false, shade(u, v)))
  private val Clear = Ramp(0, alpha = 0)

  /** Evenly spread in [0, 1), the same on each run. */
  private def speckle(u: Int, v: Int, seed: Int): Double = {
    var h = u * 0x27d4eb2d + v * 0x165667b1 + seed * 0x9e3779b9
    h = (h ^ h >>> 15) * 0x85ebca6b
    h = (h ^ h >>> 13) * 0xc2b2ae35
    ((h ^ h >>> 16) >>> 8) / (1 << 24).toDouble
  }

  private def plain(name: String, rgb: Int, contrast: Double, seed: Int) =
    single(name, Ramp(rgb, contrast))(speckle(_, _, seed))

  /** Grains of a second colour. */
  private def ore(name: String, rgb: Int, seed: Int) = Painting(
    name,
    Ramp(0x8c8c8c, 0.35),
    Ramp(rgb),
    (u, v) =>
      Dab(speckle(u / 2, v / 2, seed) > 0.8, speckle(u, v, seed + 1))
  )

  /** A cover on the upper part of the sides. */
  private def covered(name: String, rgb: Int, seed: Int) = Painting(
    name,
    Ramp(0x8a6242),
    Ramp(rgb),
    (u, v) =>
      Dab(v < 3 + (speckle(u, 0, seed) * 3).toInt, speckle(u, v, seed + 1))
  )

  /** Stones in rows with joints between. */
  private def wall(name: String, stone: Int, joint: Int, width: Int, height: Int, seed: Int) =
    Painting(
      name,
      Ramp(stone),
      Ramp(joint, 0.2),
      { (u, v) =>
        val row = v / height
        Dab((u + row % 2 * (width / 2)) % width == 0 || v % height == height - 1, speckle(u, v, seed))
      }
    )

  private def wool(name: String, rgb: Int) =
    single(name, Ramp(rgb, 0.3))((u, v) => ((u + v) % 4 + speckle(u, v, rgb)) / 5)

  private def edge(u: Int, v: Int) = u == 0 || v == 0 || u == Side - 1 || v == Side - 1

  private val paintings: IndexedSeq[Painting] = IndexedSeq(
    plain("stone", 0x8c8c8c, 0.35, 1),
    plain("dirt", 0x8a6242, 0.45, 2),
    plain("grass", 0x6ab04a, 0.4, 3),
    covered("grass side", 0x6ab04a, 4),
    plain("sand", 0xe2d49c, 0.2, 5),
    plain("gravel", 0x9a918c, 0.55, 6),
    wall("cobble", 0x8f8f8f, 0x505050, 6, 4, 7),
    Painting(
      "planks",
      Ramp(0xb98a50, 0.3),
      Ramp(0x6a4a28, 0.2),
      (u, v) =>
        Dab(v % 4 == 3 || (u == v / 4 % 2 * 8 && v % 4 != 3), speckle(u / 4, v, 8))
    ),
    single("bark", Ramp(0x6e5231, 0.5))((u, v) => (speckle(u, v / 5, 9) + speckle(u, v, 10)) / 2),
    Painting(
      "log end",
      Ramp(0xc29a62, 0.35),
      Ramp(0x6e5231),
      { (u, v) =>
        val ring = (2 * u - 15).abs.max((2 * v - 15).abs) / 2
        Dab(ring == 7, if (ring % 2 == 0) 0.9 else 0.3)
      }
    ),
    Painting(
      "leaves",
      Ramp(0x3f8a33, 0.55),
      Clear,
      (u, v) => Dab(speckle(u, v, 11) > 0.78, speckle(u, v, 12))
    ),
    single("water", Ramp(0x3a6ee0, 0.25, alpha = 7))((u, v) =>
      (speckle((u + v) / 3, v / 2, 13) + speckle(u, v, 14)) / 2
    ),
    Painting(
      "glass",
      Ramp(0xd8f0f4, 0.2),
      Ramp(0xc8e8f0, 0.1, alpha = 2),
      (u, v) =>
        Dab(!edge(u, v) && !((u - v).abs == 5 && u < 10 && v < 10), 0.9)
    ),
    wall("brick", 0xa8503c, 0xc8c0b4, 8, 4, 15),
    plain("snow", 0xf6fafc, 0.1, 16),
    covered("snow side", 0xf6fafc, 17),
    single("ice", Ramp(0xa8ccf4, 0.2, alpha = 11))((u, v) =>
      if ((u + 2 * v) % 11 == 0) 1 else speckle(u, v, 18) / 2
    ),
    ore("coal", 0x303030, 19),
    ore("iron", 0xd8a888, 21),
    ore("gold", 0xf4d048, 23),
    Painting(
      "shelf",
      Ramp(0xb98a50, 0.3),
      Ramp(0xc05040, 0.8),
      (u, v) =>
        Dab(v % 8 > 1 && u % 15 != 0, speckle(u / 2, v / 8, 25))
    ),
    wool("red wool", 0xc83c38),
    wool("blue wool", 0x3c58c8),
    wool("yellow wool", 0xe8cc40),
    Painting(
      "lamp",
      Ramp(0xfff0b0, 0.3),
      Ramp(0x806030, 0.2),
      (u, v) =>
        Dab(edge(u, v), 1 - ((2 * u - 15).abs + (2 * v - 15).abs) / 40.0)
    ),
    plain("basalt", 0x3c3844, 0.5, 27),
    Painting(
      "cactus side",
      Ramp(0x4c9048, 0.35),
      Ramp(0x204020),
      (u, v) => Dab(u % 4 == 1 && v % 3 == 1, if (u % 4 == 3) 0 else 0.8)
    ),
    Painting("cactus", Ramp(0x5ca058, 0.3), Ramp(0x2c5c2c), (u, v) => Dab(edge(u, v), speckle(u, v, 28))),
    Painting(
      "mossy stone",
      Ramp(0x8c8c8c, 0.35),
      Ramp(0x5a8a44),
      (u, v) => Dab(speckle(u / 3, v / 3, 29) > 0.55, speckle(u, v, 30))
    ),
    plain("clay", 0xa4a8b8, 0.15, 31),
    single("sandstone", Ramp(0xdcc888, 0.3))((u, v) =>
      (if (v % 5 == 4) 0 else 0.6) + speckle(u, v, 32) * 0.4
    ),
    Painting(
      "marble",
      Ramp(0xf0eee8, 0.15),
      Ramp(0xa8a4a8, 0.2),
      (u, v) =>
        Dab((u + (6 * scala.math.sin(v / 2.5)).toInt + 32) % 9 == 0, speckle(u, v, 33))
    )
  )

  def names: Seq[String] = paintings.map(_.name)
  def index(name: String): Int = names.indexOf(name).ensuring(_ >= 0, s"no texture '$name'")

  val textures: VoxelTextures = VoxelTextures(
    paintings.map { p =>
      for (v <- 0 until Side; u <- 0 until Side) yield {
        val dab = p.dab(u, v)
        (dab.shade.max(0).min(1) * 7.999).toInt + (if (dab.second) 8 else 0)
      }
    },
    paintings.map(p => (p.first.colors ++ p.second.colors).toIndexedSeq)
  )
}
