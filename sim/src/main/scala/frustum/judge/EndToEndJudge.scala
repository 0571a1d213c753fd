package frustum.judge

import frustum.contract.raster.RasterConfig
import frustum.driver.raster.{DrawOptions, PreparedFrame}
import frustum.driver.scene.{Camera, Scene}
import frustum.referee.{EndToEnd, Llvmpipe, Seen, WorldPicture, WorldView}
import frustum.reference.raster.Shading

/** A frame against what the user asked for: drawn once more from the world, by code that shares nothing with the
  * driver.
  *
  * @param world       float64's counts, the same on every machine: what bounds are for
  * @param counts      the referee's: of llvmpipe where it is installed, else those of float64
  * @param worldPicture,picture the same two drawings, 0xRRGGBB
  */
final case class EndToEndVerdict(
    world: EndToEnd,
    counts: EndToEnd,
    worldPicture: Array[Int],
    picture: Array[Int]
)

object EndToEndJudge {

  /** What the driver is asked for, in the referee's words. */
  def view(scene: Scene, camera: Camera, options: DrawOptions, config: RasterConfig): WorldView = WorldView(
    scene,
    camera,
    config.width,
    config.height,
    options.light,
    options.cullBack,
    options.wrap,
    options.background,
    options.turnDegrees,
    options.depthTest
  )

  /** @param logs fragments of each pass
    * @param rgb  the picture as the engine drew it
    */
  def judge(
      view: WorldView,
      frame: PreparedFrame,
      logs: Seq[IndexedSeq[LoggedFragment]],
      rgb: Array[Int]
  ): EndToEndVerdict = {
    val world = new WorldPicture(view)
    val llvmpipe = Llvmpipe.draw(view)
    val shown = seen(frame, logs)
    val own = EndToEnd.judge(world, None, shown, rgb)
    EndToEndVerdict(
      own,
      llvmpipe.fold(own)(m => EndToEnd.judge(world, Some(m.seen), shown, rgb)),
      world.picture,
      llvmpipe.fold(world.picture)(_.picture)
    )
  }

  /** What the fragments leave at each pixel, by the numbers that the scene has for its triangles. */
  def seen(frame: PreparedFrame, logs: Seq[IndexedSeq[LoggedFragment]]): Seen = {
    val shown = new Seen(frame.config.width * frame.config.height)
    for (((pass, sources), log) <- frame.passes.zip(frame.sources).zip(logs); f <- log if f.drawn) {
      val state = pass.states(pass.triangles(f.triangle).state)
      val texel = Shading.textureOf(state).map(_ => (f.texelS, f.texelT))
      shown.write(f.y * frame.config.width + f.x, sources(f.triangle), Seen.texel(texel), state.blend)
    }
    shown
  }
}
