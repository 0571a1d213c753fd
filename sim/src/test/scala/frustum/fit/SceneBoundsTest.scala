package frustum.fit

import frustum.contract.raster.{RasterConfig, VertexRanges, Wrap}
import frustum.driver.raster.{DrawOptions, Driver}
import frustum.driver.scene.Scene
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

/** What interval arithmetic says of a scene holds for every view, and is no more than twice what is seen. */
class SceneBoundsTest extends AnyFunSuite {
  private val seed = 3L
  private val config = RasterConfig()

  private def bounds(scene: Scene, volume: CameraVolume = CameraVolume.default) = SceneBounds(
    scene,
    volume,
    config.width,
    config.height,
    DrawOptions(None, cullBack = false, Wrap.Repeat, scene.background)
  )

  /** Random views and the ends of the volume. */
  private def views(volume: CameraVolume): Seq[View] = {
    val random = new Random(seed)
    Seq.fill(60)(volume.random(random)) ++ (for {
      turn <- Seq(volume.turn._1, 0, volume.turn._2)
      elevation <- Seq(volume.elevation._1, volume.elevation._2)
      distance <- Seq(volume.distance._1, volume.distance._2)
    } yield View(turn, elevation, distance))
  }

  private val far = CameraVolume((-180, 180), (-40, 40), (2, 5))

  for (
    (scene, volume) <- Seq(
      Scenes.cube -> CameraVolume.default,
      Scenes.cube -> far,
      Scenes.teapot(3) -> CameraVolume.default,
      Scenes.teapot(3) -> far,
      Scenes.floor -> CameraVolume.default,
      Scenes.byName("terrain") -> CameraVolume.default
    )
  )
    test(s"${scene.name}, ${volume.distance}: nothing goes beyond") {
      val b = bounds(scene, volume)
      val options = DrawOptions(None, cullBack = false, Wrap.Repeat, scene.background)
      val frames = views(volume).map(v => Driver.prepare(scene, v.camera(scene.camera), options, config, 0))
      val passes = frames.flatMap(_.passes)
      for (v <- passes.flatMap(_.vertices)) assert(v.fault(b.ranges).isEmpty, s"seed $seed: $v, ${b.ranges}")
      val textured = frames.flatMap(_.clipTriangles).filter(_.state.texture.isDefined)
      for (t <- textured) {
        val w = t.v.map(_.clip.w)
        assert(w.max <= w.min * (1 << b.ranges.ratio), s"seed $seed: $t, ${b.ranges}")
      }
      if (b.whole) for (p <- passes)
        assert(
          p.vertices.length <= b.vertices && p.triangles.length <= b.triangles,
          s"seed $seed: ${p.vertices.length}"
        )
    }

  test("the cube needs half of the screen's range, one repeat, a ratio of 2, a store of 24 vertices and 12 triangles") {
    val b = bounds(Scenes.cube)
    assert(b.ranges == VertexRanges(position = 9, repeats = 1, ratio = 1) && b.whole)
    assert((b.vertices, b.triangles) == (24, 12))
    val widest = Driver.prepare(
      Scenes.cube,
      View(0, 0, 0.9).camera(Scenes.cube.camera),
      DrawOptions(None, cullBack = true, Wrap.Repeat, 0),
      config,
      0
    ).passes.flatMap(_.vertices).flatMap(v => Seq(v.x.abs, v.y.abs)).max
    assert(widest > 16 * 256, "a bit less would do")
  }

  test("an eye that may be inside, a triangle that may be cut: everything is kept") {
    val inside = bounds(Scenes.cube, CameraVolume((0, 0), (0, 0), (0.1, 1)))
    assert(!inside.whole && inside.ranges.position == 10 && inside.ranges.ratio >= 2)
    val floor = bounds(Scenes.floor)
    assert(!floor.whole && floor.ranges.position == 10 && floor.ranges.ratio >= 6 && floor.ranges.repeats >= 3)
    val features = FitFeatures(Scenes.floor, config, DrawOptions(None, cullBack = false, Wrap.Repeat, 0))
    assert(features.config.maxVertices == 1024 && features.config.maxTriangles == 1024)
    val low = Scenes.cube.copy(camera = Scenes.cube.camera.copy(near = 3.3))
    assert(!bounds(low).whole, "the near plane cuts it")
  }
}
