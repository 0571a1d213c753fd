package frustum.charts.systems

import frustum.contract.raster.RasterConfig
import frustum.driver.raster.{Driver, PreparedFrame}
import frustum.driver.scene.Scene
import frustum.judge.{EndToEndJudge, Flip, FragmentLog}
import frustum.picture.Picture
import frustum.referee.{EndToEnd, WorldPicture}
import frustum.reference.raster.ReferenceRaster

/** How far a picture is from what the user asked for, end to end.
  *
  * @param flip         mean FLIP against float64's drawing from the world
  * @param wrongPercent judged pixels that show another triangle or another texel, of 100, see
  *                     [[frustum.referee.EndToEnd]]
  */
final case class SystemError(flip: Double, wrongPercent: Double)

object SystemError {

  /** @param judged,primitiveWrong,texelsWrong counts of the referee */
  def apply(flip: Double, counts: EndToEnd): SystemError =
    SystemError(flip, 100.0 * (counts.primitiveWrong + counts.texelsWrong) / counts.judged.max(1))
}

/** Draws a scene with configurations by their models, and judges it by the referee's float64 drawing: the same
  * figures on every machine.
  */
final class SystemErrors(scene: Scene, width: Int, height: Int) {
  private val flip = new Flip(width, height)
  private val world = {
    val config = RasterConfig(width = width, height = height)
    new WorldPicture(EndToEndJudge.view(scene, scene.camera, SystemConfiguration.plain(scene), config))
  }

  /** The frame as it is sent. */
  def frame(c: SystemConfiguration): PreparedFrame =
    c.sent(Driver.prepare(scene, scene.camera, c.options, c.config, 0))

  def apply(c: SystemConfiguration): SystemError = {
    val sent = frame(c)
    val memory = ReferenceRaster.texelMemory(sent.textures)
    val image = new Array[Int](width * height)
    val renderer = c.renderer(c.config)
    val logs = sent.passes.map { pass =>
      val log = new FragmentLog
      renderer.draw(pass, memory, image, Some(log))
      log.fragments
    }
    val rgb = Picture.ofRgb565(image).map(c.shown)
    SystemError(
      flip.mean(world.picture, rgb),
      EndToEnd.judge(world, None, EndToEndJudge.seen(sent, logs), rgb)
    )
  }
}
