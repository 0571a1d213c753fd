package frustum.scene

import frustum.InputError
import java.nio.file.Path

object ObjScene {
  def read(file: Path, textureOverride: Option[Path]): Scene = throw InputError(file.toString)
}
