package frustum.command.pong

import frustum.contract.arithmetic.IntVector
import frustum.contract.InputError
import frustum.contract.ray.{RayCamera, RayCameraRange, RayScene}
import frustum.contract.video.VideoMode
import frustum.demos.pong.{PongPipelineConfig, PongRules, PongScene}
import frustum.scene.RaySceneFile
import java.nio.file.Path

/** What `pong` draws. */
object PongScenes {

  /** The room of pong, seen from its place through a screen as wide as the room, whatever the mode. */
  def room(mode: VideoMode): RayScene = {
    val scene = PongScene.room(mode.width, mode.height)
    val focal = -PongScene.Eye.z * mode.width / (scene.room.high.x - scene.room.low.x)
    scene.copy(camera = RayCameraRange(RayCamera.forward(PongScene.Eye, mode.width, mode.height, focal)))
  }

  /** The game in its room, or in the one of a file, where puck and paddle must be able to go wherever the rules take
    * them.
    */
  def config(mode: VideoMode, file: Option[Path]): PongPipelineConfig = file match {
    case None    => PongPipelineConfig(mode = mode, scene = room(mode))
    case Some(f) =>
      val scene = RaySceneFile.read(f, room(mode), mode.width, mode.height)
      def refuse(what: String): Nothing = throw InputError(s"$f: $what")
      def covers(low: IntVector, high: IntVector, from: IntVector, to: IntVector, axes: Range, what: String)
          : Unit =
        if (axes.exists(a => low(a) > from(a) || high(a) < to(a)))
          refuse(
            s"$what goes from $from to $to by the rules, the scene's from $low to $high: let it go there"
          )
      val config =
        try PongPipelineConfig(mode = mode, scene = scene)
        catch { case e: IllegalArgumentException => refuse(e.getMessage.stripPrefix("requirement failed: ")) }
      import PongRules._
      covers(
        scene.spheres.head.low,
        scene.spheres.head.high,
        PuckLow,
        PuckHigh,
        0 to 2,
        "the puck, sphere 0,"
      )
      val quad = scene.quads.head
      covers(
        quad.low,
        quad.high,
        IntVector(-PaddleX, -PaddleY, 0),
        IntVector(PaddleX, PaddleY, 0),
        0 to 1,
        "the paddle, quad 0,"
      )
      config
  }
}
