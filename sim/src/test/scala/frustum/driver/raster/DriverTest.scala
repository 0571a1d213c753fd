package frustum.driver.raster

import frustum.contract.InputError
import frustum.contract.raster.{Combine, Domain, Wrap}
import frustum.driver.linear.Vector3
import frustum.driver.raster.Fixtures._
import frustum.driver.scene.{Camera, Material, Scene, SceneOrigin}
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite

class DriverTest extends AnyFunSuite {
  private val front = triangle(vertex(-50, -50), vertex(50, -50), vertex(0, 50))
  private val back = triangle(vertex(-50, -50), vertex(0, 50), vertex(50, -50))

  private def areas(p: PreparedFrame) = p.passes.flatMap(pass =>
    pass.triangles.map { t =>
      new Viewport(config).area(pass.vertices(t.v0), pass.vertices(t.v1), pass.vertices(t.v2))
    }
  )

  test("what is drawn turns clockwise on the screen, whichever way it faced") {
    assert(areas(prepare(scene(Seq(front, back)))) == Seq(100L * 16 * 100 * 16, 100L * 16 * 100 * 16))
  }

  test("back faces are culled on request") {
    val p = prepare(scene(Seq(back, front)), options.copy(cullBack = true))
    assert((p.sceneTriangles, p.trianglesDrawn, areas(p).length) == ((2, 1, 1)))
    assert(p.clipTriangles.map(_.source) == Seq(1), "the front face is the one that stays")
  }

  test("triangles without area are not drawn") {
    val line = triangle(vertex(-50, -50), vertex(0, 0), vertex(50, 50))
    val point = triangle(vertex(1, 1), vertex(1, 1), vertex(1, 1))
    assert(prepare(scene(Seq(line, point, front))).trianglesDrawn == 1)
  }

  test("unquantised triangles come in drawing order") {
    val p = prepare(Scenes.teapot())
    val pass = p.passes.head
    val viewport = new Viewport(config)
    assert(p.clipTriangles.length == pass.triangles.length)
    for ((clip, packed) <- p.clipTriangles.zip(pass.triangles))
      assert(clip.v.map(viewport.pack(_, (0, 0))) == Seq(packed.v0, packed.v1, packed.v2).map(pass.vertices))
  }

  test("a closed mesh costs at most 20 bytes a triangle on the wire") {
    for ((name, mesh) <- Seq("sphere" -> scene(sphere(16, 30, 100)), "teapot" -> Scenes.teapot())) {
      val p = prepare(mesh, options.copy(light = Some(Vector3(1, 2, 3))))
      val bytes = p.passes.flatMap(Driver.commands).flatten.length
      info(f"$name: ${bytes.toDouble / p.trianglesDrawn}%.2f bytes a triangle")
      assert(p.passes.length == 1 && bytes <= 20 * p.trianglesDrawn, name)
    }
  }

  test("a closed mesh covers every pixel as often from the front as from the back") {
    val p = prepare(scene(sphere(10, 14, 100)))
    val culled = prepare(scene(sphere(10, 14, 100)), options.copy(cullBack = true))
    assert(areas(culled).sum * 2 == areas(p).sum)
  }

  test("blended triangles follow the opaque ones, far to near") {
    val glass = Material("glass", (1, 1, 1), 0.5, None, Combine.ColorOnly, blend = true, None)
    def at(z: Double, material: Int) =
      triangle(vertex(-50, -50, z), vertex(50, -50, z), vertex(0, 50, z), material)
    val p = prepare(scene(Seq(at(3, 1), at(-2, 1), at(1, 0), at(5, 1), at(0, 0)), Material.White, glass))
    val pass = p.passes.head
    val drawn = pass.triangles.map(t => (pass.states(t.state).blend, pass.vertices(t.v0).z))
    assert(drawn.map(_._1) == Seq(false, false, true, true, true))
    assert(drawn.drop(2).map(-_._2) == drawn.drop(2).map(-_._2).sorted)
    assert(pass.states.filter(_.blend).forall(!_.depthWrite))
    assert(pass.vertices.map(_.a).toSet == Set(255, 128))
  }

  test("light: Lambert with ambient 0.2, and it does not turn with the model") {
    def red(options: DrawOptions) = prepare(scene(Seq(front)), options).passes.head.vertices.map(_.r).distinct
    def lit(x: Double, y: Double, z: Double) = options.copy(light = Some(Vector3(x, y, z)))
    assert(red(lit(0, 0, 5)) == Seq(255))
    assert(red(lit(0, 0, -5)) == Seq(51))
    assert(red(lit(3, 0, 4)) == Seq(((0.2 + 0.8 * 0.8) * 255).round))
    assert(red(lit(0, 0, 5).copy(turnDegrees = 60)) == Seq((0.6 * 255).round))
  }

  test("a light without direction is refused") {
    for (light <- Seq(Vector3.Zero, Vector3(0, Double.NaN, 0)))
      assert(
        intercept[InputError](prepare(scene(Seq(front)), options.copy(light = Some(light)))).message
          .contains("has no direction")
      )
  }

  test("light shows on textures") {
    val p = scene(Seq(front), textured(8, 8))
    assert(prepare(p).passes.head.states.map(_.combine) == Seq(Combine.Replace))
    assert(
      prepare(p, options.copy(light = Some(Vector3(1, 0, 0)))).passes.head.states.map(_.combine) == Seq(
        Combine.Modulate
      )
    )
  }

  test("turning goes about +y through the centre, counter-clockwise from above") {
    def place(degrees: Double) =
      prepare(
        scene(Seq(triangle(vertex(0, 0), vertex(80, 0), vertex(80, 40)))),
        options.copy(turnDegrees = degrees)
      ).passes.head.vertices.map(v => (v.x / 16.0 - 120, v.z)).toSet
    assert(place(180).map(_._1) == Set(0.0, 80.0))
    assert(place(10).maxBy(_._1)._2 > place(10).minBy(_._1)._2, "its right side moves away from the eye")
  }

  test("w of a frame is scaled by a power of two where that helps, refused where not") {
    def seen(near: Double, far: Double, scale: Double) = {
      val wall = Seq(
        triangle(vertex(-scale, -scale, -scale), vertex(scale, -scale, -scale), vertex(0, scale, -4 * scale))
      )
      val camera = Camera(Vector3.Zero, Vector3(0, 0, -1), Vector3(0, 1, 0), 60, near, far)
      Driver.prepare(scene(wall), camera, options, config, 0)
    }
    val plain = seen(0.1, 10, 1)
    for (scale <- Seq(1e-6, 1e6)) {
      val p = seen(0.1 * scale, 10 * scale, scale)
      val w = p.clipTriangles.flatMap(_.v.map(_.clip.w))
      assert(w.min >= Domain.MinW && w.max <= Domain.MaxW)
      assert(
        p.passes.head.vertices.map(v => (v.x, v.y, v.z)) == plain.passes.head.vertices.map(v =>
          (v.x, v.y, v.z)
        )
      )
    }
    val deep = Seq(1e-3, 1e6).map(d => triangle(vertex(-d, -d, -d), vertex(d, -d, -d), vertex(0, d, -d)))
    val camera = Camera(Vector3.Zero, Vector3(0, 0, -1), Vector3(0, 1, 0), 60, 1e-4, 1e7)
    val error = intercept[InputError](Driver.prepare(scene(deep), camera, options, config, 0))
    assert(error.message.contains("262144 times") && error.message.contains("near plane"))
  }

  test("cameras that see nothing are refused") {
    val c = Scenes.cube.camera
    for (
      (camera, part) <- Seq(
        c.copy(at = c.eye) -> "same point",
        c.copy(up = c.eye) -> "line of sight",
        c.copy(up = Vector3.Zero) -> "line of sight",
        c.copy(near = 0) -> "near 0.0 must be above 0",
        c.copy(far = 0.1) -> "must be less than far",
        c.copy(fovDegrees = 180) -> "fov 180.0",
        c.copy(orthoHeight = Some(0)) -> "ortho 0.0",
        c.copy(eye = Vector3(1e300, 0, 0)) -> "eye 1.0E300,0.0,0.0 is beyond",
        c.copy(eye = Vector3(Double.NaN, Double.NaN, Double.NaN)) -> "not finite"
      )
    ) {
      val error = intercept[InputError](Driver.prepare(Scenes.cube, camera, options, config, 0))
      assert(error.message.contains(part))
    }
  }

  test("a seventeenth render state is refused") {
    val materials = (1 to 17).map(i => Material.White.copy(name = s"m$i", alphaTest = Some(i / 31.0)))
    def meshOf(n: Int) = scene((0 until n).map(i => front.copy(material = i)), materials: _*)
    assert(prepare(meshOf(16)).passes.head.states.length == 16)
    assert(
      intercept[InputError](prepare(meshOf(17))).message.contains("17 render states, the hardware holds 16")
    )
  }

  /** Two triangles of a square of 200 pixels, `repeats` along both axes from `start` on. */
  private def tiled(repeats: Double, start: Double): Scene = {
    def at(x: Int, y: Int) = vertex(-100 + 200 * x, -100 + 200 * y, 0, start + repeats * x, start + repeats * y)
    scene(
      Seq(triangle(at(0, 0), at(1, 0), at(1, 1)), triangle(at(0, 0), at(1, 1), at(0, 1))),
      textured(8, 8)
    )
  }

  test("triangles with more repeats than the vertex format holds are cut, and neighbours meet") {
    for (wrap <- Seq(Wrap.Repeat, Wrap.Mirror); start <- Seq(0.0, 0.3, -77.1, 1001.0)) {
      assert(prepare(tiled(253, start), options.copy(wrap = wrap)).trianglesDrawn == 2)
      for (repeats <- Seq(256.0, 300.7, 600, Domain.MaxMeshRepeats)) {
        val p = prepare(tiled(repeats, start), options.copy(wrap = wrap))
        val viewport = new Viewport(config)
        val corners = p.clipTriangles.map(_.v.map(viewport.pack(_, (0, 0))))
        assert(corners.map(c => viewport.area(c(0), c(1), c(2))).sum == 2 * 200L * 16 * 200 * 16, "gaps or overlaps")
        for (pass <- p.passes; v <- pass.vertices) assert(v.fault.isEmpty)
        if (p.passes.length == 1)
          for ((clip, t) <- p.clipTriangles.zip(p.passes.head.triangles))
            for ((v, packed) <- clip.v.zip(Seq(t.v0, t.v1, t.v2).map(p.passes.head.vertices))) {
              val off = v.s - packed.s / 65536.0
              assert((off - off.round).abs < 1e-4 && off.round % 2 == 0, "whole repeats, an even number")
            }
      }
    }
  }

  test("what cannot be drawn is refused with its place: the scene's triangle, or the file's line") {
    def message(s: Scene, o: DrawOptions = options) = intercept[InputError](prepare(s, o)).message
    val wide = tiled(Domain.MaxMeshRepeats * 2, 0)
    assert(message(wide).startsWith("test: triangle 1: texture coordinate s runs from 0.0 to 2048.0 repeats"))
    val read = wide.copy(origin = Some(SceneOrigin(java.nio.file.Paths.get("a.obj"), IndexedSeq(7, 8))))
    assert(message(read).startsWith("a.obj:7: texture coordinate s"))
    assert(message(tiled(200, 0), options.copy(wrap = Wrap.Clamp)).startsWith("test: triangle 1: texture coordinate s"))
    // too close to each other in depth to say which is hidden
    val crowd =
      (0 until 1100).map(i => triangle(vertex(-1, -1, i * 1e-6), vertex(1, -1, i * 1e-6), vertex(0, 1, i * 1e-6)))
    assert(message(scene(crowd)).startsWith("test: 1100 triangles with"))
  }
}
