package frustum.play

import frustum.contract.raster.Wrap
import frustum.driver.linear.Vector3
import frustum.driver.raster.DrawOptions
import frustum.driver.scene.{Camera, Scene}
import frustum.scene.Framing
import java.awt.event.KeyEvent._
import scala.math.{atan2, cos, pow, sin, toRadians}

/** How a mesh is looked at and lit; keys and mouse make the next view of one.
  *
  * @param own       the camera that it starts with; turned about the point that it looks at
  * @param yaw,pitch by which the eye is turned to the right and upwards, degrees
  * @param zoom      the eye's distance, of the start's
  * @param light     whether it is lit; from `lightYaw` to the right of +z and `lightPitch` above the horizon, degrees
  * @param held      keys that were down: what a key switches it switches once
  */
final case class RasterView(
    scene: Scene,
    own: Camera,
    yaw: Double = 0,
    pitch: Double = 0,
    zoom: Double = 1,
    light: Boolean = false,
    lightYaw: Double = 30,
    lightPitch: Double = 40,
    cullBack: Boolean = false,
    held: Set[Int] = Set.empty
) {
  import RasterView._

  def next(keys: Set[Int], mouse: PointerMoves): RasterView = {
    def along(more: Int, less: Int) = (if (keys(more)) 1 else 0) - (if (keys(less)) 1 else 0)
    def pressed(key: Int) = keys(key) && !held(key)
    val from = if (pressed(VK_R)) RasterView(scene, own) else this
    val nearer = (if (keys.exists(Nearer)) 1 else 0) - (if (keys.exists(Farther)) 1 else 0)
    val (lightRight, lightUp) = (along(VK_D, VK_A), along(VK_W, VK_S))
    val lightMoves = lightRight != 0 || lightUp != 0 || mouse.otherX != 0 || mouse.otherY != 0
    from.copy(
      yaw = from.yaw + KeyDegrees * along(VK_RIGHT, VK_LEFT) - DegreesPerPixel * mouse.dragX,
      pitch = clamp(
        from.pitch + KeyDegrees * along(VK_UP, VK_DOWN) + DegreesPerPixel * mouse.dragY,
        -steepest - elevation,
        steepest - elevation
      ),
      zoom = clamp(from.zoom * pow(ZoomStep, mouse.wheel - nearer), 1 / MostZoom, MostZoom),
      light = (from.light ^ pressed(VK_L)) || lightMoves,
      lightYaw = from.lightYaw + KeyDegrees * lightRight + DegreesPerPixel * mouse.otherX,
      lightPitch = clamp(from.lightPitch + KeyDegrees * lightUp - DegreesPerPixel * mouse.otherY, -90, 90),
      cullBack = from.cullBack ^ pressed(VK_C),
      held = keys
    )
  }

  private def up = own.up.normalized
  private def away = own.eye - own.at

  /** Horizontal direction from what is looked at to the eye. */
  private def level: Vector3 = {
    val flat = away - up * away.dot(up)
    if (flat.length > 1e-9 * away.length) flat.normalized
    else Vector3.Axes.map(_.cross(up)).maxBy(_.length).normalized
  }

  /** The start's, degrees above the horizon. */
  private def elevation = scala.math.toDegrees(atan2(away.dot(up), away.dot(level)))

  /** The start is never too steep. */
  private def steepest = Steepest.max(elevation.abs)

  /** @param aspect width / height of the picture */
  def camera(aspect: Double): Camera =
    if (yaw == 0 && pitch == 0 && zoom == 1) own
    else {
      val angle = toRadians(elevation + pitch)
      val turned = level.turned(up, toRadians(yaw)) * cos(angle) + up * sin(angle)
      val eye = own.at + turned * (away.length * zoom)
      if (scene.origin.isDefined)
        Framing(scene.boundingSphere, aspect, own.fovDegrees, Some(eye), Some(own.at), Some(own.up))
      else {
        val (centre, radius) = scene.boundingSphere
        own.copy(eye = eye, far = own.far.max(eye.distance(centre) + 1.1 * radius))
      }
    }

  def options: DrawOptions = {
    val (a, b) = (toRadians(lightYaw), toRadians(lightPitch))
    DrawOptions(
      Option.when(light)(Vector3(cos(b) * sin(a), sin(b), cos(b) * cos(a))),
      cullBack,
      Wrap.Repeat,
      scene.background
    )
  }

  /** For the window's title. */
  def state: String =
    (Seq(s"light ${if (light) "on" else "off"}") ++ Option.when(cullBack)("back faces left out")).mkString(", ")
}

object RasterView {
  val help: String =
    "keys: arrows turn, + and - zoom, l switches the light, w a s d move it, c leaves out back faces, r starts " +
      "again; mouse: drag turns, wheel zooms, drag with shift or the right button moves the light; close the window " +
      "to end"

  /** Of a frame. */
  private val KeyDegrees = 3.0
  private val DegreesPerPixel = 0.5
  private val ZoomStep = 1.05
  private val MostZoom = 20.0

  /** Above and below the horizon, short of looking along the up vector. */
  private val Steepest = 85.0

  private val Nearer = Set(VK_PLUS, VK_EQUALS, VK_ADD, VK_PAGE_UP)
  private val Farther = Set(VK_MINUS, VK_SUBTRACT, VK_PAGE_DOWN)

  private def clamp(v: Double, least: Double, most: Double) = v.max(least.min(most)).min(most.max(least))

  /** As `render` shows it without a camera. */
  def apply(scene: Scene, aspect: Double): RasterView =
    RasterView(scene, if (scene.origin.isDefined) Framing(scene.boundingSphere, aspect) else scene.camera)
}
