package frustum.driver.raster

import frustum.contract.raster.RasterConfig
import frustum.driver.linear.Vector3
import frustum.driver.scene.{Scene, Triangle}
import frustum.engine.raster.{EngineOptions, RasterEngines}
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite

/** Which faces are the back ones is judged in world space, from corners and eye alone: a triangle is listed
  * counter-clockwise as seen from its front, so (v1 - v0) x (v2 - v0) points to where the front is seen from. That is
  * OpenGL's convention: counter-clockwise in window coordinates, y upwards, is front (OpenGL 2.1, 2.14.1 and 3.5.1).
  */
class CullingTest extends AnyFunSuite {
  private val config = RasterConfig(width = 128, height = 96)
  private val culled = Fixtures.options.copy(cullBack = true)

  private def outwards(t: Triangle) =
    (t.v1.position - t.v0.position).cross(t.v2.position - t.v0.position)

  /** Above 0 where the eye is on the side that the front faces; towards an orthographic eye all lines are parallel. */
  private def facing(s: Scene, t: Triangle): Double = {
    val towardsEye =
      if (s.camera.orthoHeight.isDefined) s.camera.eye - s.camera.at
      else s.camera.eye - t.v0.position
    outwards(t).dot(towardsEye.normalized) / outwards(t).length
  }

  /** Convex and closed, from several sides, in both projections. */
  private val solids: Seq[Scene] = {
    val ball = Scenes.cube.copy(name = "ball", triangles = Fixtures.sphere(6, 9, 0.6))
    for {
      scene <- Seq(Scenes.cube, ball)
      eye <- Seq(scene.camera.eye, Vector3(-2, -2.5, 1.5), Vector3(0.3, 0.2, -3.9), Vector3(3.8, 0.1, 0))
      ortho <- Seq(None, Some(2.0))
    } yield scene.copy(camera = scene.camera.copy(eye = eye, orthoHeight = ortho))
  }

  private def picture(frame: PreparedFrame) =
    RasterEngines.byName("model").make(EngineOptions(1, None)).drawAll(Seq(frame)).head.image

  test("the front faces are kept and the back faces are dropped") {
    for (s <- solids) {
      val kept = Fixtures.prepare(s, culled, config).clipTriangles.map(_.source).toSet
      for ((t, i) <- s.triangles.zipWithIndex; f = facing(s, t) if f.abs > 1e-3)
        assert(kept(i) == f > 0, s"${s.name} from ${s.camera.eye}: triangle $i faces the eye by $f")
    }
  }

  test("a closed convex mesh looks the same with its back faces culled as without") {
    for (s <- solids) {
      val (all, fronts) = (Fixtures.prepare(s, config = config), Fixtures.prepare(s, culled, config))
      assert(fronts.trianglesDrawn < all.trianglesDrawn)
      val different = picture(all).zip(picture(fronts)).count { case (a, b) => a != b }
      assert(different == 0, s"${s.name} from ${s.camera.eye}, ortho ${s.camera.orthoHeight}: pixels")
    }
  }

  test("culled front faces need no depth test") {
    for (s <- solids) {
      val flat = Fixtures.prepare(s, culled.copy(depthTest = false), config)
      val deep = Fixtures.prepare(s, config = config)
      assert(picture(flat).sameElements(picture(deep)), s"${s.name} from ${s.camera.eye}")
    }
  }
}
