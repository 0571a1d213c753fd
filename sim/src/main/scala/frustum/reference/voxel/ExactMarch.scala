package frustum.reference.voxel

import frustum.contract.voxel.{BlockTable, SeenFace, VoxelConfig}
import frustum.referee.WorldBlocks

/** A ray from an eye through the world, block by block, in whole numbers and therefore exact.
  *
  * Times at which borders are crossed are fractions that are compared crosswise. Of borders that are crossed at one
  * time, that of x comes first, then y, then z. A point on a border of blocks or texels belongs to the one that the ray
  * goes into.
  *
  * @param eye in units of 2^-eyeBits blocks
  * @param direction of any length
  * @param down whether the ray goes down along each axis; what has been rounded to 0 still goes somewhere
  */
final class ExactMarch(
    c: VoxelConfig,
    table: BlockTable,
    world: WorldBlocks,
    eye: Seq[Int],
    direction: Seq[Long],
    down: Seq[Boolean]
) {
  require(
    (0 to 2).forall(k => direction(k) == 0 || direction(k) < 0 == down(k)),
    s"$direction goes elsewhere than $down"
  )
  private val one = 1L << c.eyeBits
  private val sign = down.map(d => if (d) -1 else 1)
  private val run = direction.map(_.abs)
  // Positions and blocks are counted in the direction of travel, from the world's origin.
  private val from = (0 to 2).map(k => eye(k).toLong * sign(k))
  private val blocks = Array.tabulate(3)(k => Math.floorDiv(from(k), one))

  /** Way to the next border and how fast it is covered: the fraction is the time. */
  private def way(k: Int): Long = (blocks(k) + 1) * one - from(k)
  private def before(k: Int, l: Int): Boolean = way(k) * run(l) < way(l) * run(k)

  private def coordinate(k: Int): Int = (if (sign(k) > 0) blocks(k) else -1 - blocks(k)).toInt
  private def id: Int = world(coordinate(0), coordinate(1), coordinate(2))
  private def gone: Boolean = (0 to 2).exists { k =>
    if (sign(k) > 0) coordinate(k) >= c.size.axes(k) else coordinate(k) < 0
  }

  /** The faces in view up to the first opaque one. */
  def march(): Seq[SeenFace] = {
    val seen = Seq.newBuilder[SeenFace]
    var going = !gone
    var previous = if (going) id else 0
    val limit = c.slabs.head + 1
    while (going) {
      val axis =
        (1 to 2).foldLeft(0)((best, k) => if (run(k) > 0 && (run(best) == 0 || before(k, best))) k else best)
      val (n, d) = (way(axis), run(axis))
      blocks(axis) += 1
      going = !gone && (0 to 2).forall(k => blocks(k) - Math.floorDiv(from(k), one) <= limit)
      if (going) {
        val here = id
        if (here != 0 && !(here == previous && table(here).joins)) {
          val t = (0 to 2).map { k => // texels from the block's corner, in the direction of travel
            if (k == axis) 0
            else Math.floorDiv(16 * ((from(k) - blocks(k) * one) * d + run(k) * n), d * one).toInt.min(15)
          }
          val far =
            (0 to 2).map(k => 16 * blocks(k) + t(k) - Math.floorDiv(16 * from(k), one)).map(x => x * x).sum
          if (far > c.farSquared) going = false
          else {
            val face = 2 * axis + (if (sign(axis) < 0) 1 else 0)
            val (u, v) = ExactMarch.uv(face, (0 to 2).map(k => if (sign(k) < 0) 15 - t(k) else t(k)))
            seen += SeenFace(coordinate(0), coordinate(1), coordinate(2), here, face, u, v)
            going = !table(here).opaque
          }
        }
        previous = here
      }
    }
    seen.result()
  }
}

object ExactMarch {

  /** Texel column and row (downwards) on a face of a point in texels within its block. */
  def uv(face: Int, t: Seq[Int]): (Int, Int) = {
    val right = Seq(15 - t(1), t(1), t(0), 15 - t(0), t(0), 15 - t(0))(face)
    (right, if (face < 4) 15 - t(2) else t(1))
  }
}
