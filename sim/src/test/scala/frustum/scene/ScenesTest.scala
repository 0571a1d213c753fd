package frustum.scene

import frustum.contract.InputError
import frustum.contract.raster.RasterConfig
import frustum.driver.raster.{Driver, Fixtures}
import org.scalatest.funsuite.AnyFunSuite

class ScenesTest extends AnyFunSuite {
  test("every scene: triangles face their normals, materials exist, one pass") {
    for (name <- Scenes.names) {
      val scene = Scenes.byName(name)
      assert(scene.name == name)
      for (t <- scene.triangles) {
        assert(scene.materials.indices.contains(t.material), name)
        val face = Grid.faceNormal(t).get
        assert(t.vertices.forall(v => (v.normal.length - 1).abs < 1e-9), s"$name: $t")
        // the sum, because a coarse face at the spout's lip may lean away from one of its normals
        assert(t.vertices.map(_.normal.dot(face)).sum > 0, s"$name: $t")
      }
      assert(Fixtures.prepare(scene).passes.length == 1, name)
    }
  }

  test("triangle counts") {
    assert(
      Scenes.names.map(n => n -> Scenes.byName(n).triangles.length).toMap
        == Map("teapot" -> 952, "cube" -> 12, "floor" -> 2, "corridor" -> 98, "terrain" -> 1000)
    )
  }

  test("an unknown scene is refused with the names there are") {
    assert(
      intercept[InputError](Scenes.byName("bunny")).message ==
        "there is no scene 'bunny'; choose one of teapot, cube, floor, corridor, terrain"
    )
  }

  test("the cube fills about half of 240 x 320 at every turn") {
    for (turn <- 0 until 90 by 15) {
      val pass = Driver
        .prepare(
          Scenes.cube,
          Scenes.cube.camera,
          Fixtures.options.copy(cullBack = true, turnDegrees = turn),
          RasterConfig(),
          0
        )
        .passes
        .head
      // convex: what faces the eye covers the outline once, so areas add up
      val area = pass.triangles.map { t =>
        val (a, b, c) = (pass.vertices(t.v0), pass.vertices(t.v1), pass.vertices(t.v2))
        (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
      }.sum / 512
      assert(area >= 36000 && area <= 41000, s"$area pixels at $turn degrees")
      assert(
        pass.vertices.forall(v => v.x >= 0 && v.x <= 240 * 16 && v.y >= 0 && v.y <= 320 * 16),
        s"$turn degrees"
      )
    }
  }

  test("the floor has the numbers of its figures") {
    val p = Scenes.floor.triangles.flatMap(_.vertices)
    assert(p.map(_.position.y).toSet == Set(-1.0))
    assert(
      (
        p.map(_.position.z).min,
        p.map(_.position.z).max,
        p.map(_.position.x).min,
        p.map(_.position.x).max
      ) == ((-100, -1, -50, 50))
    )
    assert(p.map(v => (v.s, v.t)).toSet == Set((0.0, 0.0), (8.0, 0.0), (0.0, 8.0), (8.0, 8.0)))
  }
}
