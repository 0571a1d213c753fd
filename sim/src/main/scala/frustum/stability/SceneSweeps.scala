package frustum.stability

import frustum.contract.raster.{Combine, FixedState, RasterConfig, RasterDomains, VertexRanges, Wrap}
import frustum.driver.linear.Vector3
import frustum.driver.raster.{DrawOptions, Driver, PreparedFrame}
import frustum.driver.scene.{Camera, Material, MeshVertex, Scene, TextureImage, Triangle}
import frustum.engine.raster.{EngineOptions, RasterEngines}
import frustum.judge.{FrameJudge, FrameVerdict}
import frustum.picture.Picture
import frustum.raster.texture.LateDivide
import frustum.scene.{Grid, Pictures}

/** Scenes through driver and model, held against the reference by the judges. */
object SceneSweeps {
  private val config = RasterConfig(96, 96)
  private val repeat = DrawOptions(None, cullBack = false, Wrap.Repeat, 0)
  private val origin = Vector3.Zero
  private val up = Vector3(0, 1, 0)
  private val checks =
    Material("checks", (1, 1, 1), 1, Some(Pictures.checker), Combine.Replace, blend = false, None)
  private val plain = Seq(0xff0000, 0x00ff00).map { c =>
    Material(
      f"$c%06x",
      ((c >> 16) / 255.0, (c >> 8 & 255) / 255.0, 0),
      1,
      None,
      Combine.ColorOnly,
      blend = false,
      None
    )
  }

  private def prepare(
      triangles: IndexedSeq[Triangle],
      materials: Seq[Material],
      camera: Camera,
      options: DrawOptions = repeat,
      hardware: RasterConfig = config
  ): PreparedFrame =
    Driver.prepare(
      Scene("sweep", triangles, materials.toIndexedSeq, camera, 0),
      camera,
      options,
      hardware,
      0
    )

  private def drawn(frame: PreparedFrame): Array[Int] =
    RasterEngines.byName("model").make(EngineOptions(1, None)).drawAll(Seq(frame)).head.image

  private def judged(frame: PreparedFrame): FrameVerdict =
    new FrameJudge(RasterEngines.model, simulated = false).judge(
      frame,
      RasterEngines.byName("model").make(EngineOptions(1, None)).drawAll(Seq(frame)).head
    )

  /** Wrong texels in per cent of those judged; one wrong by more than a texel makes them all wrong. */
  private def texelsWrong(frame: PreparedFrame): Double = {
    val texels = judged(frame).model.get.texels
    if (texels.judged == 0) 0.0
    else if (texels.wrongByMoreThanOne > 0) 100.0
    else 100.0 * texels.wrong / texels.judged
  }

  private val ahead = Vector3(0, 0, -1)

  /** A floor at y = -`height`, from `start` to `far` before the eye, the texture 8 times along it. */
  private def floor(
      start: Double,
      far: Double,
      height: Double,
      near: Double,
      options: DrawOptions = repeat,
      hardware: RasterConfig = config
  ): PreparedFrame = {
    val quad = Grid.rectangle(
      Vector3(-far / 2, -height, -start),
      Vector3(far, 0, 0),
      Vector3(0, 0, start - far),
      (8, 8),
      (1, 1),
      0
    )(_ => (1, 1, 1, 1))
    prepare(quad, Seq(checks), Camera(origin, ahead, up, 60, near, far * 1.01), options, hardware)
  }

  /** The same floor on hardware that was made for it alone, and for depths near each other. */
  private def fittedFloor(ratio: Double): PreparedFrame = {
    val flat = repeat.copy(depthTest = false)
    val states = floor(1, 2, 1, 0.5, flat).passes.flatMap(_.states)
    val fitted =
      config.copy(ranges = VertexRanges(ratio = VertexRanges.LateRatio), fixed = FixedState.of(states: _*))
    require(LateDivide.suits(fitted), s"the sweep's hardware, $fitted, has another divide")
    floor(1, ratio, 1, 0.5, flat, fitted)
  }

  /** A wall before an orthographic eye, `size` times the screen's height, its texture from `-reach` to 1 + `reach`. */
  private def wall(size: Double, reach: Double, material: Material, wrap: Wrap): PreparedFrame = {
    val quad = Grid.rectangle(
      Vector3(-size / 2, -size / 2, -2),
      Vector3(size, 0, 0),
      Vector3(0, size, 0),
      (1 + 2 * reach, 1 + 2 * reach),
      (1, 1),
      0
    )(_ => (1, 1, 1, 1))
    val shifted = quad.map { t =>
      def shift(v: MeshVertex) = v.copy(s = v.s - reach, t = v.t - reach)
      t.copy(v0 = shift(t.v0), v1 = shift(t.v1), v2 = shift(t.v2))
    }
    prepare(shifted, Seq(material), Camera(origin, ahead, up, 60, 1, 4, Some(1.0)), repeat.copy(wrap = wrap))
  }

  /** Pixels in per cent that show the farther of two walls. It is drawn first: with equal depths it stays. */
  private def orderWrong(nearer: Double, farther: Double, camera: Camera): Double = {
    val size = 4 * farther.max(camera.orthoHeight.getOrElse(0.0))
    val quads = Seq(farther -> 0, nearer -> 1).flatMap { case (z, material) =>
      Grid.rectangle(
        Vector3(-size, -size, -z),
        Vector3(2 * size, 0, 0),
        Vector3(0, 2 * size, 0),
        (1, 1),
        (1, 1),
        material
      )(_ => (1, 1, 1, 1))
    }
    val picture = Picture.ofRgb565(drawn(prepare(quads.toIndexedSeq, plain, camera)))
    100.0 * picture.count(_ != 0x00ff00) / picture.length
  }

  /** A triangle that reaches `screens` beyond the screen: pixels covered otherwise than before it was clipped and
    * rounded.
    */
  private def overhang(screens: Double): Double = {
    val corners =
      Seq((-0.3 - screens, -0.2), (0.4 + screens / 3, -0.4 - screens), (0.1 + screens, 0.3 + screens))
    val vertices = corners.map { case (x, y) =>
      MeshVertex(Vector3(x, y, -2), Vector3(0, 0, 1), 0, 0, (1, 1, 1, 1))
    }
    val triangle = Triangle(vertices(0), vertices(1), vertices(2), 0)
    val camera = Camera(origin, ahead, up, 60, 1, 4, Some(1.0))
    val wrong =
      judged(prepare(IndexedSeq(triangle), plain.take(1), camera)).snapping.coverageWrong
    100.0 * wrong / (config.width * config.height)
  }

  private def stripes(log2: Int): Material = {
    val side = 1 << log2
    val picture = TextureImage(
      side,
      side,
      IndexedSeq.tabulate(side * side)(i => 0xff000000 | (i * 2654435761L).toInt),
      hasAlpha = false
    )
    checks.copy(texture = Some(picture))
  }

  val all: Seq[Sweep] = Seq(
    Sweep(RasterDomains.SceneScale, 1e-9, 1e9, 5, Some(PeerDomain(0.5, 1.28, "w above 0.5 and below 128")))(k =>
      texelsWrong(floor(k, 100 * k, k, k / 2))
    ),
    Sweep(RasterDomains.FarOverNear, 1.01, 1 << 22, 100)(ratio => texelsWrong(floor(1, ratio, 1, 0.5))),
    Sweep(RasterDomains.LateRatio, 1.01, 1 << 10, 100)(ratio => texelsWrong(fittedFloor(ratio))),
    Sweep(RasterDomains.NearPlane, 1e-7, 0.5, 100)(near => texelsWrong(floor(-10, 100, 100 * near, 100 * near))),
    Sweep(RasterDomains.EyeHeight, 1e-4, 64, 100)(height => texelsWrong(floor(1, 100, height, 0.5))),
    Sweep(RasterDomains.Overhang, 1, 1e9, 5)(overhang),
    Sweep(RasterDomains.Clamped, 1, 1024, 5, Some(PeerDomain(1, 2, "clamped within +-2")))(reach =>
      texelsWrong(wall(1, reach, checks, Wrap.Clamp))
    ),
    Sweep(RasterDomains.TextureSide, 1, 10, 5, Some(PeerDomain(5, 7, "32, 64 or 128 square")), whole = true)(log2 =>
      texelsWrong(wall(1.3, 1, stripes(log2.toInt), Wrap.Repeat))
    ),
    Sweep(RasterDomains.DepthGap, 1e-5, 1, 100)(gap =>
      orderWrong(99 / (1 + gap), 99, Camera(origin, ahead, up, 60, 1, 100))
    ),
    Sweep(RasterDomains.OrthoDepth, 1e-9, 1e9, 0, Some(PeerDomain(None, "orthographic depth breaks it")))(range =>
      orderWrong(
        0.5 * range,
        0.501 * range,
        Camera(origin, ahead, up, 60, 0, range, Some(range))
      )
    )
  )
}
