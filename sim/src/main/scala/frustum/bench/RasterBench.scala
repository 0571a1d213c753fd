package frustum.bench

import frustum.contract.raster.{FramePass, RasterConfig, RenderState, TileRegion, Wrap}
import frustum.driver.raster.{DrawOptions, Driver, PreparedFrame}
import frustum.engine.EngineSim
import frustum.engine.raster.{DrawnPass, PipelineEngine, PipelineEvent, PipelineSession}
import frustum.model.raster.{FragmentSink, Rasterizer}
import frustum.scene.Scenes

/** The figures of `bench raster`, in clocks unless the name says otherwise; see the specification for the scenes. */
final case class RasterFigures(
    fullScreenClocksPerPixel: Double,
    setupClocks: Double,
    tileRebaseClocks: Double,
    rightTriangleClocks: Seq[(Int, Double)],
    randomIn16Clocks: Double,
    diagonalSliverClocks: Double,
    needleClocksPerPixel: Double,
    bytesPerTriangle: Double,
    cubeClocksPerFrame: Double,
    textureUploadClocks: Double,
    clearClocksPerFrame: Double
)

/** Measures the Stream core in simulation: store loaded, pixels taken at once.
  *
  * @param positions random positions that each average is taken over
  * @param say       told of progress
  */
final class RasterBench(seed: Long, positions: Int, say: String => Unit) {
  private val config = RasterConfig()
  private val image = new Array[Int](config.width * config.height)
  private val loads = new Workloads(config, seed)

  def run(): RasterFigures = EngineSim.run(PipelineEngine.compile(config), None, seed) { dut =>
    val session = new PipelineSession(dut, seed)
    def draw(passes: Seq[FramePass]): Seq[DrawnPass] = {
      passes.flatMap(Driver.commands).foreach(session.send)
      passes.map(session.take(_, image))
    }
    def costs(name: String)(corners: => Workloads.Corners): Seq[(FramePass, TriangleCost)] = {
      say(name)
      val passes = Seq.fill(positions)(loads.frame(corners, TriangleCost.Copies))
      passes.zip(draw(passes)).flatMap { case (pass, drawn) => TriangleCost.of(drawn).map(pass -> _) }
    }
    def meanTotal(costs: Seq[(FramePass, TriangleCost)]) = mean(costs.map(_._2.total))

    val upload = uploadClocks(session)
    Driver.commands(loads.texture).foreach(session.send)
    say("whole screens")
    val empty = draw(Seq.fill(2)(loads.empty(TileRegion.whole(config)))).last
    val full = draw(Seq.fill(2)(loads.fullScreen)).last
    val right =
      Seq(1, 2, 4, 8, 16, 32, 50).map(n => n -> costs(s"right triangles of $n pixels")(loads.rightTriangle(n)))
    val small = right.toMap.apply(4).map(_._2)
    val needles = costs("needles")(loads.needle)
    val figures = RasterFigures(
      fullScreenClocksPerPixel = full.clocks.toDouble / (config.width * config.height),
      // Of so small a triangle the drawing is hidden behind the set-up.
      setupClocks = mean(small.map(_.firstTile)),
      tileRebaseClocks = mean(small.flatMap(_.others)),
      rightTriangleClocks = right.map { case (n, c) => n -> meanTotal(c) },
      randomIn16Clocks = meanTotal(costs("random triangles in 16 x 16")(loads.randomIn16)),
      diagonalSliverClocks = meanTotal(costs("diagonal slivers")(loads.diagonalSliver)),
      needleClocksPerPixel = needles.map(_._2.total).sum / needles.map { case (pass, _) =>
        pixels(pass)
      }.sum * TriangleCost.Copies,
      bytesPerTriangle = teapotBytes,
      cubeClocksPerFrame = cubeClocks(session, draw),
      textureUploadClocks = upload,
      clearClocksPerFrame = empty.clocks.toDouble
    )
    if (session.faulty) throw new IllegalStateException(s"the link refused what was sent: ${session.status}")
    figures
  }

  /** From the first byte fed to the last texel written: what an upload delays the frame sent behind it. */
  private def uploadClocks(session: PipelineSession): Double = {
    val tile = loads.empty(TileRegion(0, 0, 0, 0))
    def start(before: Seq[Seq[Int]]): Long = {
      session.reset()
      (before ++ Driver.commands(tile)).foreach(session.send)
      session.take(tile, image).events.find(_.kind == PipelineEvent.Start).get.time
    }
    (start(Driver.commands(loads.texture)) - start(Nil)).toDouble
  }

  /** The textured cube, culled, as it turns once about in twelve frames. */
  private def cubeClocks(session: PipelineSession, draw: Seq[FramePass] => Seq[DrawnPass]): Double = {
    say("the cube")
    val scene = Scenes.byName("cube")
    val frames: Seq[PreparedFrame] = (0 until 12).map { i =>
      Driver.prepare(scene, scene.camera, DrawOptions(None, cullBack = true, Wrap.Repeat, 0, 30.0 * i), config, i)
    }
    frames.head.textures.flatMap(Driver.commands).foreach(session.send)
    draw(frames.flatMap(_.passes)).map(_.clocks).sum.toDouble / frames.length
  }

  /** Everything on the wire for the teapot, a closed mesh, over its triangles. */
  private def teapotBytes: Double = {
    val scene = Scenes.byName("teapot")
    val frame = Driver.prepare(scene, scene.camera, DrawOptions(None, cullBack = false, Wrap.Repeat, 0), config, 0)
    PipelineEngine.busBytes(frame).toDouble / frame.trianglesDrawn
  }

  private def pixels(pass: FramePass): Double = {
    var count = 0
    Rasterizer(config).draw(
      pass,
      new FragmentSink {
        def tile(x: Int, y: Int): Unit = ()
        def fragment(
            n: Int,
            st: RenderState,
            x: Int,
            y: Int,
            s: Int,
            t: Int,
            q: Int,
            z: Int,
            r: Int,
            g: Int,
            b: Int,
            a: Int
        ): Unit =
          count += 1
        def tileEnd(x: Int, y: Int): Unit = ()
      }
    )
    count
  }

  private def mean(values: Seq[Double]): Double = if (values.isEmpty) 0 else values.sum / values.length
}
