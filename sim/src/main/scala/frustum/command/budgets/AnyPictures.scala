package frustum.command.budgets

import frustum.budgets.Measured
import frustum.command.render.{EndToEndBounds, SceneRun}
import frustum.contract.raster.{RasterConfig, Wrap}
import frustum.driver.linear.Vector3
import frustum.driver.raster.DrawOptions
import frustum.driver.scene.Camera
import frustum.engine.raster.{EngineOptions, RasterEngines}
import frustum.scene.Scenes

/** Pictures that ask for other things than the scenes by default: what the driver does for them is judged from the
  * world.
  */
object AnyPictures {
  private val plain = DrawOptions(None, cullBack = false, Wrap.Repeat, 0)
  private val lit = plain.copy(light = Some(Vector3(3, 2, 1)), cullBack = true)

  private def run(scene: String, options: DrawOptions, width: Int, height: Int)(camera: Camera => Camera): SceneRun = {
    val s = Scenes.byName(scene)
    SceneRun(
      s,
      camera(s.camera),
      options,
      RasterConfig(width = width, height = height),
      frames = 2,
      turnDegrees = 35,
      RasterEngines.byName("model"),
      EngineOptions(1, None)
    )
  }

  val all: Seq[SceneRun] = Seq(
    run("teapot", lit, 160, 120)(identity),
    run("teapot", plain, 120, 160)(_.copy(eye = Vector3(2.5, 2, 1), at = Vector3(0, 1, 0), near = 0.5)),
    run("cube", lit, 160, 120)(_.copy(eye = Vector3(-2, -1.5, 2.5), up = Vector3(1, 3, 0))),
    run("cube", lit, 128, 96)(_.copy(orthoHeight = Some(1.9))),
    run("floor", plain.copy(wrap = Wrap.Mirror), 160, 120)(_.copy(fovDegrees = 95)),
    run(
      "floor",
      plain.copy(wrap = Wrap.Clamp),
      120,
      160
    )(_.copy(eye = Vector3(3, 6, -20), at = Vector3(-4, -1, -40))),
    run(
      "corridor",
      lit.copy(cullBack = false),
      160,
      120
    )(_.copy(eye = Vector3(-1, 1, -4), at = Vector3(1, 1.5, 1))),
    run("terrain", plain, 120, 160)(_.copy(fovDegrees = 30))
  )

  /** The worst of them. */
  def measured(): Seq[Measured] = {
    val figures = all.map(r => EndToEndBounds.ofAny(r.figures((_, _) => ()).endToEnd.get))
    Seq(figures.flatten.maxBy(_.value))
  }
}
