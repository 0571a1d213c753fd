package frustum.command.play

import frustum.command.voxel.VoxelOptions
import frustum.contract.InputError
import frustum.contract.video.VideoMode
import frustum.engine.{EngineEntry, EngineTable}
import java.nio.file.Path

/** Arguments of `play`. */
final case class PlayOptions(
    what: String = "",
    engine: Option[String] = None,
    mode: VideoMode = VideoMode.Vga640x480,
    scene: Option[String] = None,
    obj: Option[Path] = None,
    size: Option[(Int, Int)] = None,
    voxel: VoxelOptions = VoxelOptions(),
    fly: Boolean = false,
    frames: Option[Int] = None,
    seed: Long = 1
) {

  /** The engine asked for, of those of what is played; the first of them by default. */
  def engineOf[E <: EngineEntry[Nothing, Any]](table: EngineTable[E], playable: Seq[String]): E = {
    val name = engine.getOrElse(playable.head)
    if (!playable.contains(name))
      throw InputError(s"--engine: '$name' does not play $what; choose one of ${playable.mkString(", ")}")
    table.byName(name)
  }
}
