package frustum.judge

import frustum.contract.ray.{RayMotion, RayScene}
import frustum.reference.ray.ExactRay

/** Judges frames of a ray caster, given as object ids and 0xRRGGBB, against exact arithmetic. A wall or a quad has its
  * paint's colour or, in shadow, half of it; any other counts as a wrong cell or texel.
  */
class RayJudge(scene: RayScene, width: Int, height: Int) {
  private val exact = new ExactRay(scene)
  private val firstSphere = 2 + scene.quads.size

  def apply(motion: RayMotion, objects: Array[Int], rgb: Array[Int]): RayCounts = {
    require(
      objects.length == width * height && rgb.length == width * height,
      s"${rgb.length} pixels for $width x $height"
    )
    var silhouette, shadow, wrong, cells, over = 0
    var most = 0.0
    val want = new Array[Int](width * height)
    for (v <- 0 until height; h <- 0 until width) {
      val at = v * width + h
      val e = exact(motion, h, v)
      val seen = Seq(16, 8, 0).map(s => rgb(at) >> s & 255)
      want(at) = Seq(16, 8, 0).zip(e.rgb).map { case (s, c) => scala.math.round(c).toInt << s }.sum
      if ((objects(at) >= firstSphere) != (e.objectId >= firstSphere)) silhouette += 1
      if (objects(at) != e.objectId) wrong += 1
      else if (e.objectId >= 1 && e.objectId < firstSphere) {
        val (lit, dark) = (e.paint, e.paint >> 1 & 0x7f7f7f)
        val (is, other) = if (e.shadowed) (dark, lit) else (lit, dark)
        if (rgb(at) == other && is != other) shadow += 1 else if (rgb(at) != is) cells += 1
      }
      val error = seen.zip(e.rgb).map { case (s, c) => (s - c).abs }.max
      most = most.max(error)
      if (error > 1) over += 1
    }
    RayCounts(rgb.length, silhouette, shadow, wrong, cells, most, over, Psnr.squaredError(rgb, want))
  }
}
