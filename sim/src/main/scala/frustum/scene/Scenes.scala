package frustum.scene

import frustum.InputError

object Scenes {
  val names: Seq[String] = Seq("teapot", "cube", "floor", "corridor", "terrain")
  def byName(name: String): Scene = throw InputError(name)
}
