package frustum.model.voxel.march

import frustum.contract.voxel.{BlockTable, LeapField, VoxelConfig}

/** What a ray meets: a face seen from outside, in mirrored space.
  *
  * @param block mirrored coordinates, as of the axes
  * @param entry which axis' border the ray crossed into the block: 0 the fast one, 1 and 2 the others
  * @param at positions along the two other axes at the last border of the fast axis
  */
final case class FaceHit(ray: RayStart, id: Int, block: Seq[Int], entry: Int, at: Seq[Long])

/** Walks a ray through the world: one word of its memory a step. */
final class Marcher(c: VoxelConfig, table: BlockTable, words: Array[Int]) {
  private val shift = c.fractionBits
  private val whole = c.size.axes

  /** Visits the faces from the front until an opaque one, the edge of the world or the end of view; gives the steps. */
  def march(ray: RayStart)(visit: FaceHit => Unit): Int = {
    val Seq(a, b) = ray.others
    val Seq(slopeA, slopeB) = ray.slopes.map(_.toLong << c.eyeBits)
    val octant = ray.octant
    var plane = ray.plane
    var (atA, atB) = (ray.at(0), ray.at(1))
    var (pastA, pastB) = (ray.crossed(0), ray.crossed(1))
    var entry = -1
    var (previous, steps) = (0, 0)
    val end = ray.plane + ray.slabs
    val block = new Array[Int](3)
    def floor(at: Long) = (at >> shift).toInt
    var marching = true
    while (marching) {
      steps += 1
      block(ray.fast) = plane
      block(a) = floor(atA) + (if (pastA) 1 else 0)
      block(b) = floor(atB) + (if (pastB) 1 else 0)
      if (plane > end || (0 to 2).exists(k => block(k) >= whole(k))) marching = false
      else {
        val inside = block.forall(_ >= 0)
        val word = if (inside) words(address(block, ray.mirrored)) else 0
        val id = c.leaps.id(word)
        if (id != 0 && entry >= 0 && !(id == previous && table(id).joins)) {
          visit(FaceHit(ray, id, block.toSeq, entry, Seq(atA, atB)))
          if (table(id).opaque) marching = false
        }
        previous = id
        val reach = if (inside && id == 0) c.leaps.distance(word, octant) else 1
        val (farA, farB) = (atA + reach * slopeA, atB + reach * slopeB)
        val fits = floor(farA) - block(a) < reach && floor(farB) - block(b) < reach
        if (fits || reach > 1) { // the far side of the cube, or the border before it
          val back = if (fits) 0 else 1
          plane += reach - back
          atA = farA - back * slopeA
          atB = farB - back * slopeB
          pastA = false
          pastB = false
          entry = 0
        } else {
          val crossA = !pastA && floor(farA) > floor(atA)
          val crossB = !pastB && floor(farB) > floor(atB)
          val first = crossA && (!crossB || sooner(ray, atA, atB))
          if (first) pastA = true else pastB = true
          entry = if (first) 1 else 2
        }
      }
    }
    steps
  }

  /** Whether the next border of the first of the other axes comes before the second's. */
  private def sooner(ray: RayStart, atA: Long, atB: Long): Boolean = {
    val Seq(toA, toB) = Seq(atA, atB).zipWithIndex.map { case (at, i) =>
      (1L << shift) - (at & (1L << shift) - 1) - (if (ray.low(i)) 1 else 0)
    }
    val (p, q) = (toA * ray.slopes(1), toB * ray.slopes(0))
    if (ray.others(0) < ray.others(1)) p <= q else p < q
  }

  private def address(block: Array[Int], mirrored: Seq[Boolean]): Int = {
    def k(axis: Int) = RayAxes.block(c, mirrored, block(axis), axis)
    c.size.address(k(0), k(1), k(2))
  }
}
