package frustum.model.voxel.wide

import frustum.contract.voxel.VoxelConfig
import frustum.model.voxel.march.{FaceHit, RayAxes}

/** Where on its face a ray meets a block.
  *
  * @param face in order of travel, +x -x +y -y +z -z
  * @param away from the eye's texel to this one, along each axis, as magnitudes
  */
final case class FaceTexel(face: Int, u: Int, v: Int, away: Seq[Int]) {
  def farSquared: Int = away.map(d => d * d).sum
}

object FaceTexel {

  /** u and v of a texel within its block, on a face: u to the right and v down for one who looks at it. */
  def uv(face: Int, t: Seq[Int]): (Int, Int) = {
    val Seq(x, y, z) = t
    face match {
      case 0 => (15 - y, 15 - z)
      case 1 => (y, 15 - z)
      case 2 => (x, 15 - z)
      case 3 => (15 - x, 15 - z)
      case 4 => (x, y)
      case 5 => (15 - x, y)
    }
  }

  def apply(hit: FaceHit, eye: Seq[Int], c: VoxelConfig): FaceTexel = {
    val ray = hit.ray
    val axes = ray.fast +: ray.others
    val t = new Array[Int](3) // texels within the block, mirrored
    val one = 1L << c.fractionBits
    def at(i: Int) = hit.at(i) + (if (ray.low(i)) 1 else 0) - hit.block(ray.others(i)) * one
    if (hit.entry == 0)
      for (i <- 0 to 1) t(ray.others(i)) = (at(i) >> c.fractionBits - 4).toInt.min(15)
    else {
      val (own, other) = (hit.entry - 1, 2 - hit.entry)
      val (p, q) = (ray.slopes(own).toLong, ray.slopes(other).toLong)
      val run = -at(own) // to the border crossed, along its axis
      t(ray.fast) = sixteenths(run, p << c.eyeBits)
      t(ray.others(other)) = sixteenths(at(other) * p + run * q, p << c.fractionBits)
    }
    val axis = axes(hit.entry)
    val mirrored = ray.mirrored
    val face = 2 * axis + (if (mirrored(axis)) 1 else 0)
    val (u, v) = uv(face, (0 to 2).map(k => if (mirrored(k)) 15 - t(k) else t(k)))
    val away = (0 to 2).map { k =>
      16 * hit.block(k) + t(k) - (RayAxes.mirroredEye(c, mirrored, eye, k) >> c.eyeBits - 4)
    }
    FaceTexel(face, u, v, away)
  }

  /** floor(16 n / d), at most 15: four steps of a division. */
  private def sixteenths(n: Long, d: Long): Int = {
    var (rest, digits) = (n, 0)
    for (k <- 3 to 0 by -1) {
      val part = d >> 4 << k
      digits <<= 1
      if (rest >= part) { rest -= part; digits |= 1 }
    }
    digits
  }
}
