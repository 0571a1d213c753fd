package frustum.command

import frustum.InputError
import frustum.spec.{PongScene, RayCamera, RayScene, VideoMode}
import java.nio.file.Path

/** What `pong` draws. */
object PongScenes {

  /** The room of pong, seen from its place through a screen as wide as the room, whatever the mode. */
  def room(mode: VideoMode): RayScene = {
    val scene  = PongScene.room(mode.width, mode.height)
    val focal  = -PongScene.Eye.z * mode.width / (scene.room.high.x - scene.room.low.x)
    scene.copy(camera = RayCamera.forward(PongScene.Eye, mode.width, mode.height, focal))
  }

  def apply(mode: VideoMode, file: Option[Path]): RayScene =
    file.fold(room(mode))(f => throw InputError(s"--scene $f: not yet"))
}
