package frustum.scene

import frustum.contract.voxel.WorldSize
import frustum.demos.voxel.Blocks
import scala.math.floor
import scala.util.Random

/** A world from a seed: hills with snow on the highest, lakes with beaches, caves with ore, trees and a hut of glass.
  */
object Hills {
  def apply(size: WorldSize, seed: Long): VoxelWorld = {
    val surface = Array.tabulate(size.x, size.y) { (x, y) =>
      val n = 0.6 * noise(x / 15.0, y / 15.0, 0, seed) + 0.3 * noise(x / 6.0, y / 6.0, 7, seed) +
        0.1 * noise(x / 3.0, y / 3.0, 13, seed)
      (size.z * (0.1 + 0.55 * n)).toInt.min(size.z - 2)
    }
    val sea = (size.z * 0.3).toInt
    val snowLine = (size.z * 0.52).toInt
    val ids = Array.ofDim[Int](size.x, size.y, size.z)
    for (x <- 0 until size.x; y <- 0 until size.y) {
      val top = surface(x)(y)
      for (z <- 0 to top.max(sea)) ids(x)(y)(z) =
        if (z > top) Blocks.id("water")
        else if (z > 0 && z < top - 1 && cave(x, y, z, seed)) 0
        else if (z < top - 2) stone(x, y, z, seed)
        else if (top <= sea + 1) Blocks.id("sand")
        else if (z < top) Blocks.id("dirt")
        else Blocks.id(if (top >= snowLine) "snow" else "grass")
    }
    val random = new Random(seed)
    // A tree has its crown within the world: two blocks on either side.
    val room = size.x > 4 && size.y > 4
    if (room) for (_ <- 0 until size.x * size.y / 100) {
      val (x, y) = (2 + random.nextInt(size.x - 4), 2 + random.nextInt(size.y - 4))
      val z = surface(x)(y)
      if (z > sea + 1 && z < size.z - 8 && ids(x)(y)(z) == Blocks.id("grass"))
        tree(ids, size, x, y, z, 3 + random.nextInt(2))
    }
    hut(ids, size, surface, sea)
    VoxelWorld.tabulate(size)((x, y, z) => ids(x)(y)(z))
  }

  private def tree(
      ids: Array[Array[Array[Int]]],
      size: WorldSize,
      x: Int,
      y: Int,
      z: Int,
      trunk: Int
  ): Unit = {
    for (dx <- -2 to 2; dy <- -2 to 2; dz <- -1 to 2) {
      val (bx, by, bz) = (x + dx, y + dy, z + trunk + dz)
      if (dx.abs + dy.abs + dz.abs <= 3 && size.contains(bx, by, bz) && ids(bx)(by)(bz) == 0)
        ids(bx)(by)(bz) = Blocks.id("leaves")
    }
    for (dz <- 1 to trunk) ids(x)(y)(z + dz) = Blocks.id("log")
  }

  /** Near the middle, on the first dry ground that is found. */
  private def hut(
      ids: Array[Array[Array[Int]]],
      size: WorldSize,
      surface: Array[Array[Int]],
      sea: Int
  ): Unit = {
    val places = for (x <- size.x / 3 until size.x - 6; y <- size.y / 3 until size.y - 6) yield (x, y)
    places.find { case (x, y) => surface(x)(y) > sea && surface(x)(y) < size.z - 7 }.foreach { case (x, y) =>
      val floor = surface(x)(y)
      for (dx <- 0 to 4; dy <- 0 to 4; dz <- 0 to 4) {
        val (wallX, wallY) = (dx % 4 == 0, dy % 4 == 0)
        ids(x + dx)(y + dy)(floor + dz) =
          if (dz == 0) Blocks.id("planks")
          else if (dz == 4) Blocks.id("brick")
          else if (wallX && wallY) Blocks.id("log")
          else if (dx == 2 && dy == 0 && dz < 3) 0
          else if (wallX || wallY) Blocks.id(if (dz == 2) "glass" else "planks")
          else if (dx == 2 && dy == 2 && dz == 1) Blocks.id("lamp")
          else 0
      }
    }
  }

  private def stone(x: Int, y: Int, z: Int, seed: Long): Int = {
    val vein = hash(x / 2, y / 2, z / 2, seed + 3)
    Blocks.id(if (vein < 0.02) "gold"
    else if (vein < 0.05) "iron" else if (vein < 0.1) "coal" else if (vein < 0.16) "gravel" else "stone")
  }

  private def cave(x: Int, y: Int, z: Int, seed: Long): Boolean =
    (noise(x / 6.0, y / 6.0, 100 + z / 3, seed) + noise(x / 6.0, y / 6.0, 101 + z / 3, seed)) > 1.45

  /** Smooth in x and y, in [0, 1). */
  private def noise(x: Double, y: Double, layer: Int, seed: Long): Double = {
    val (i, j) = (floor(x).toInt, floor(y).toInt)
    def ease(t: Double) = t * t * (3 - 2 * t)
    val (u, v) = (ease(x - i), ease(y - j))
    def at(di: Int, dj: Int) = hash(i + di, j + dj, layer, seed)
    (at(0, 0) * (1 - u) + at(1, 0) * u) * (1 - v) + (at(0, 1) * (1 - u) + at(1, 1) * u) * v
  }

  /** Evenly spread in [0, 1). */
  private def hash(x: Int, y: Int, z: Int, seed: Long): Double = {
    var h = seed + x * 0x9e3779b97f4a7c15L + y * 0xc2b2ae3d27d4eb4fL + z * 0x165667b19e3779f9L
    h = (h ^ h >>> 30) * 0xbf58476d1ce4e5b9L
    h = (h ^ h >>> 27) * 0x94d049bb133111ebL
    ((h ^ h >>> 31) >>> 11) / (1L << 53).toDouble
  }
}
