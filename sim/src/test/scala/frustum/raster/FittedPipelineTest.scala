package frustum.raster

import frustum.contract.InputError
import frustum.contract.raster.{
  Combine,
  FixedState,
  PlaneFormats,
  RasterConfig,
  RenderState,
  SetupWords,
  TexelFormat,
  TextureRef,
  Wrap
}
import frustum.driver.linear.Vector3
import frustum.driver.raster.{DrawOptions, Driver}
import frustum.driver.scene.{Camera, Material, Scene}
import frustum.engine.raster.{EngineOptions, RasterEngines, PipelineEngine}
import frustum.fit.FitFeatures
import frustum.harness.Simulated
import frustum.raster.texture.LateDivide
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite

/** Hardware made for less than everything: it draws what its model draws, what it can draw it draws as the whole does,
  * and the rest is refused.
  */
class FittedPipelineTest extends AnyFunSuite {
  private val seed = 1
  private val small = RasterConfig(width = 96, height = 80)

  private def options(scene: Scene, depthTest: Boolean = true) =
    DrawOptions(None, cullBack = !depthTest, Wrap.Repeat, scene.background, depthTest = depthTest)

  private def prepare(scene: Scene, config: RasterConfig, depthTest: Boolean = true) =
    (0 to 1).map(i =>
      Driver.prepare(scene, scene.camera, options(scene, depthTest).copy(turnDegrees = 25 * i), config, i)
    )

  private def images(
      engine: String,
      scene: Scene,
      config: RasterConfig,
      depthTest: Boolean = true
  ): Seq[Seq[Int]] =
    RasterEngines.byName(engine).make(EngineOptions(
      seed,
      None
    )).drawAll(prepare(scene, config, depthTest)).map(_.image.toSeq)

  private def fixedFor(scene: Scene, depthTest: Boolean): FixedState =
    FixedState.of(prepare(scene, small, depthTest).flatMap(_.passes).flatMap(_.states): _*)

  for {
    (name, depthTest, formats, planes) <- Seq(
      ("cube", false, PlaneFormats(), "stq"),
      ("cube", false, PlaneFormats(coordinate = 7), "stq"),
      ("cube", true, PlaneFormats(coordinate = 3, depth = 9), "stqz"),
      ("teapot", true, PlaneFormats(), "zrgb"),
      ("teapot", true, PlaneFormats(depth = 11, color = 4), "zrgb"),
      ("corridor", true, PlaneFormats(coordinate = 5, depth = 4, color = 2), "stqzrgba")
    )
  } test(s"$name${if (depthTest) "" else " without depth test"}, $formats: hardware equals model", Simulated) {
    val scene = Scenes.byName(name)
    val config = small.copy(fixed = fixedFor(scene, depthTest), formats = formats)
    assert(config.fixed.planes.map("stqzrgba".charAt(_)).mkString == planes)
    val model = images("model", scene, config, depthTest)
    assert(images("pipeline", scene, config, depthTest) == model, s"seed $seed")
    if (formats == PlaneFormats())
      assert(model == images("model", scene, small, depthTest), "the full pipeline draws another picture")
  }

  for (
    (name, formats) <- Seq(
      "cube" -> PlaneFormats(4, inverse = 5),
      "cube" -> PlaneFormats(),
      "terrain" -> PlaneFormats(2),
      "floor" -> PlaneFormats()
    )
  )
    test(s"all that inspection of $name finds, $formats: hardware equals model", Simulated) {
      val scene = Scenes.byName(name)
      val features = FitFeatures(scene, small, options(scene))
      val config = features.config.copy(formats = formats)
      val depth = features.options.depthTest
      assert(name != "cube" || LateDivide.suits(config) && config.fixed.whole && config.maxVertices == 32, config)
      assert(config.clearColor.nonEmpty)
      val model = images("model", scene, config, depth)
      assert(images("pipeline", scene, config, depth) == model, s"seed $seed")
      if (formats == PlaneFormats()) {
        val full = images("model", scene, small, depth)
        val different = model.zip(full).map { case (a, b) => a.indices.count(i => a(i) != b(i)) }.sum
        assert(different <= 0.001 * model.map(_.length).sum, s"$different pixels are not as the full pipeline has them")
      }
    }

  test("the driver refuses vertices, depths and backgrounds that hardware was made without") {
    val cube = Scenes.cube
    val fitted = FitFeatures(cube, small, options(cube)).config
    def refused(s: Scene, camera: Camera) =
      intercept[InputError](Driver.prepare(s, camera, options(s, depthTest = false), fitted, 0)).message
    assert(refused(cube.copy(background = 0xffffff), cube.camera).contains("background"))
    val near = cube.camera.copy(eye = cube.camera.eye * 0.4, near = 0.1)
    assert(refused(cube, near).contains("depths of"))
    val repeated = cube.copy(triangles =
      cube.triangles.map(t =>
        t.copy(v0 = t.v0.copy(s = 3 * t.v0.s), v1 = t.v1.copy(s = 3 * t.v1.s), v2 = t.v2.copy(s = 3 * t.v2.s))
      )
    )
    assert(refused(repeated, cube.camera).contains("texture coordinate"))
  }

  test("bits that planes go without change the picture") {
    val scene = Scenes.byName("cube")
    val coarse = small.copy(formats = PlaneFormats(coordinate = 14))
    assert(images("model", scene, coarse) != images("model", scene, small))
  }

  test("fewer planes: set-up is shorter", Simulated) {
    val scene = Scenes.byName("cube")
    def clocks(c: RasterConfig) =
      new PipelineEngine(EngineOptions(
        seed,
        None
      )).drawAll(prepare(scene, c, depthTest = false)).map(_.clocks.get).sum
    val (full, fitted) = (clocks(small), clocks(small.copy(fixed = fixedFor(scene, depthTest = false))))
    info(s"$full clocks with everything, $fitted as fitted")
    assert(fitted < 0.95 * full)
  }

  test("the driver refuses what the hardware was made without, and says what") {
    val cube = Scenes.byName("cube")
    val fitted = small.copy(fixed = fixedFor(cube, depthTest = true))
    val blended = cube.copy(materials = cube.materials.map(m => m.copy(blend = true)))
    assert(intercept[InputError](prepare(blended, fitted)).message.contains("blending"))
    val plain = cube.copy(materials = IndexedSeq(Material.White))
    assert(intercept[InputError](prepare(plain, fitted)).message.contains("combine"))
    assert(intercept[InputError](prepare(cube, fitted, depthTest = false)).message.contains("depth function"))
  }

  test("constants of states: what all agree in, no more") {
    val a = RenderState(Some(TextureRef(3, 6, 5, TexelFormat.Rgb565)), combine = Combine.Modulate)
    val b = a.copy(blend = true, wrapS = Wrap.Clamp, depthWrite = false)
    val f = FixedState.of(a, b)
    assert(f.fault(a).isEmpty && f.fault(b).isEmpty)
    assert(f.constant == Seq("texture address", "texture size", "texel format", "combine", "alpha test"))
    assert(f.fault(a.copy(alphaRef = 1)).exists(_.contains("alpha test")))
    assert(f.fault(a.copy(wrapT = Wrap.Mirror)).exists(_.contains("wrap")))
    assert(f.without("alpha test").fault(a.copy(alphaRef = 31)).isEmpty)
    assert(!f.neverBlends && FixedState.of(a).neverBlends && !FixedState.None.neverBlends)
    assert(FixedState.None.planes == SetupWords.AllPlanes)
    intercept[IllegalArgumentException](FixedState.None.bits("wrapS", mask = 1, value = 2))
    intercept[IllegalArgumentException](FixedState.None.bits("wrapS", mask = 4, value = 0))
    intercept[IllegalArgumentException](FixedState.fields("fog" -> 0))
    intercept[IllegalArgumentException](PlaneFormats(coordinate = 21))
  }
}
