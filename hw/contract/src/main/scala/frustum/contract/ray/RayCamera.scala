package frustum.contract.ray

import frustum.contract.arithmetic.IntVector

/** Ray of pixel (h, v), unnormalised: corner + h right + v down, from `eye`. Integers, so that every decision on a
  * picture is exact for this camera.
  */
case class RayCamera(eye: IntVector, corner: IntVector, right: IntVector, down: IntVector) {
  def vectors: Seq[IntVector] = Seq(eye, corner, right, down)

  def direction(h: Int, v: Int): IntVector = {
    def at(a: Int) = corner(a) + h * right(a) + v * down(a)
    IntVector(at(0), at(1), at(2))
  }

  /** All rays are in one plane, so that there is no picture: corner, right and down are linearly dependent. */
  def flat: Boolean = {
    def minor(a: Int, b: Int) = BigInt(right(a)) * down(b) - BigInt(right(b)) * down(a)
    corner(0) * minor(1, 2) + corner(1) * minor(2, 0) + corner(2) * minor(0, 1) == 0
  }
}

object RayCamera {

  /** Looks along +z with `focal` units to the screen plane, 1 unit per pixel. Directions are doubled, so that rays
    * through the centres of pixels are integers; `centred` = false takes their lower left corners (h - width / 2,
    * height / 2 - 1 - v).
    */
  def forward(
      eye: IntVector,
      width: Int,
      height: Int,
      focal: Int,
      pixel: Int = 1,
      centred: Boolean = true
  ): RayCamera = {
    val (x, y) = if (centred) (1 - width, height - 1) else (-width, height - 2)
    RayCamera(
      eye,
      IntVector(x * pixel, y * pixel, 2 * focal),
      IntVector(2 * pixel, 0, 0),
      IntVector(0, -2 * pixel, 0)
    )
  }
}

/** The cameras that a ray caster accepts: each number between that of `low` and that of `high`, a register of the
  * hardware where they differ, a constant where not.
  *
  * @param lengths
  *   least and greatest length of any pixel's ray, which a camera that moves keeps to also one pixel beyond the
  *   picture: widths are proved from it. None for a constant camera, whose rays are all known.
  */
case class RayCameraRange(low: RayCamera, high: RayCamera, lengths: Option[(Int, Int)]) {
  import RayCameraRange.Vectors
  val eye: RayBox = RayBox(low.eye, high.eye)
  def fixed: Boolean = low == high
  for ((l, h) <- low.vectors.zip(high.vectors); a <- 0 to 2)
    require(l(a) <= h(a), s"camera from $l to $h")
  require(
    !fixed || !low.flat,
    s"camera: all rays are in one plane, corner ${low.corner}, right ${low.right}, down ${low.down}; none of the " +
      "three may be zero or a sum of the others"
  )
  require(
    fixed || lengths.exists { case (least, most) => 0 < least && least <= most },
    s"a camera that moves needs the least and the greatest length of its rays, both above 0: $lengths"
  )

  /** Why it does not accept a camera of a picture, if it does not. */
  def refuses(c: RayCamera, width: Int, height: Int): Option[String] = {
    val outside = c.vectors.zip(low.vectors.zip(high.vectors)).zip(Vectors).collect {
      case ((v, (l, h)), name) if (0 to 2).exists(a => v(a) < l(a) || v(a) > h(a)) =>
        s"camera's $name $v, accepted $l to $h"
    }
    outside.headOption.orElse(lengths.flatMap { case (least, most) =>
      // Lengths are greatest in a corner of the picture.
      val corners = for (h <- Seq(0, width); v <- Seq(0, height)) yield c.direction(h, v)
      val long = corners.find(d => d.dot(d) > most.toLong * most)
      def short = (for (v <- 0 until height; h <- 0 until width) yield c.direction(h, v))
        .find(d => d.dot(d) < least.toLong * least)
      long.orElse(short).map(d =>
        s"camera's ray $d is ${scala.math.sqrt(d.dot(d).toDouble).round} long, accepted $least to $most"
      )
    })
  }

  /** Squares of the rays' least and greatest lengths. */
  def squares(width: Int, height: Int): (Long, Long) = lengths match {
    case Some((least, most)) => (least.toLong * least, most.toLong * most)
    case None                =>
      val all = for (v <- 0 until height; h <- 0 until width) yield { val d = low.direction(h, v); d.dot(d) }
      (all.min, all.max)
  }
}

object RayCameraRange {

  /** Names of a camera's vectors. */
  val Vectors: Seq[String] = Seq("eye", "corner", "right", "down")

  def apply(camera: RayCamera): RayCameraRange = RayCameraRange(camera, camera, None)
}
