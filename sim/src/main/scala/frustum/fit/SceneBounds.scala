package frustum.fit

import frustum.contract.raster.{VertexRanges, Wrap}
import frustum.driver.raster.DrawOptions
import frustum.driver.scene.{MeshVertex, Scene, Triangle}
import scala.math.{ceil, floor, log, max, sqrt, tan, toRadians}

/** How far the numbers of a scene can reach from any view of a volume, by interval arithmetic alone: no view is drawn.
  *
  * The eye stays on a line to the point looked at, so a vertex at a distance r of that point has a w of d - r to d + r,
  * d being the eye's distance.
  */
final case class SceneBounds(scene: Scene, volume: CameraVolume, width: Int, height: Int, options: DrawOptions) {
  import scene.camera

  /** All that is drawn lies within this of the point looked at, however the scene is turned. */
  private val radius = scene.boundingSphere match { case (centre, r) => centre.distance(camera.at) + r }

  private val (closest, farthest) = {
    val own = camera.eye.distance(camera.at)
    (own * volume.distance._1, own * volume.distance._2)
  }

  /** Neither the near nor the far plane cuts anything. */
  private val between = closest - radius > camera.near && farthest + radius < camera.far

  /** Pixels from the screen's middle to the farthest vertex; infinite where the eye may be inside. */
  private val reach = camera.orthoHeight match {
    case Some(h)                   => radius / h * height
    case None if closest <= radius => Double.PositiveInfinity
    case None                      =>
      radius / sqrt(closest * closest - radius * radius) / tan(toRadians(camera.fovDegrees) / 2) * height / 2
  }

  private def edges(t: Triangle): Seq[Double] = t.vertices.zip(t.vertices.tail :+ t.v0).map { case (a, b) =>
    a.position.distance(b.position)
  }

  /** Greatest over least w of a triangle. */
  private val ratio =
    if (camera.orthoHeight.isDefined) 1.0
    else 1 + scene.triangles.flatMap(edges).maxOption.getOrElse(0.0) / max(camera.near, closest - radius)

  /** Repeats on either side of 0, after `frustum.driver.raster.RepeatRemoval`. */
  private val repeats =
    scene.triangles.flatMap(t => Seq(farFromZero(t, _.s), farFromZero(t, _.t))).maxOption.getOrElse(0.0)

  private def farFromZero(t: Triangle, of: MeshVertex => Double): Double = {
    val (low, high) = (t.vertices.map(of).min, t.vertices.map(of).max)
    def step(v: Double) = if (options.wrap == Wrap.Clamp) 0.0 else 4 * floor(v / 4 + 0.5)
    Seq(low, high).map(step).flatMap(o => Seq((low - o).abs, (high - o).abs)).max
  }

  private def least(range: Range)(holds: Int => Boolean) = range.find(holds).getOrElse(range.last)

  def ranges: VertexRanges = VertexRanges(
    position = least(4 to 10)(n => max(width, height) <= (1 << n) && max(width, height) / 2.0 + reach + 1 < (1 << n)),
    repeats = least(0 to 7)(n => repeats + 1.0 / 65536 < (1 << n)),
    ratio = ceil(log(ratio * 1.001) / log(2)).toInt.max(1).min(15)
  )

  /** No triangle is ever cut, nor a vertex needed twice: the mesh's own numbers of both are enough. */
  def whole: Boolean = between && width / 2.0 + reach + 1 < 1024 && height / 2.0 + reach + 1 < 1024 && repeats < 2

  def vertices: Int = scene.triangles.flatMap(t => t.vertices.map(_ -> t.material)).distinct.length
  def triangles: Int = scene.triangles.length
}
