package frustum.command.voxel

import frustum.contract.InputError
import frustum.contract.voxel.{VoxelAssets, VoxelConfig, WorldSize}
import frustum.demos.voxel.Blocks
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.files.{InputFile, Notices}
import frustum.scene.{BlockFile, Hills, VoxFile, VoxOptions, VoxelWorld}

/** What the arguments of `voxel` ask for. */
final case class VoxelScene(
    config: VoxelConfig,
    assets: VoxelAssets,
    world: VoxelWorld,
    views: Seq[VoxelView]
)

object VoxelScenes {
  def apply(o: VoxelOptions): VoxelScene = {
    val (sx, sy, sz) = o.worldSize
    WorldSize.fault(sx, sy, sz).foreach(fault => throw InputError(s"--world-size: $fault"))
    val size = WorldSize(sx, sy, sz)
    val (world, assets) = worldOf(o, size)
    val config =
      try VoxelConfig(
          size,
          o.size._1,
          o.size._2,
          o.leapField,
          o.distance
        )
      catch {
        case e: IllegalArgumentException =>
          throw InputError(s"--size: ${e.getMessage.stripPrefix("requirement failed: ")}")
      }
    def together(one: String, others: (String, Option[_])*): Unit =
      others.collectFirst { case (other, Some(_)) =>
        throw InputError(s"$one: tells what $other does; give one of them")
      }
    if (o.look.isDefined) together("--look", "--yaw" -> o.yaw, "--pitch" -> o.pitch)
    if (o.path.isDefined)
      together("--path", "--eye" -> o.eye, "--look" -> o.look, "--yaw" -> o.yaw, "--pitch" -> o.pitch)
    val focal = o.focal.getOrElse(225.0 * config.height / 240)
    val views = o.path match {
      case Some(file) => poses(file.toString, InputFile.text(file, "give a text file in UTF-8"), focal, config)
      case None       =>
        val (yaw, pitch) = o.look.fold((o.yaw.getOrElse(30.0), o.pitch.getOrElse(-10.0))) { look =>
          if (look.length == 0) throw InputError("--look 0,0,0: has no direction; give another one")
          VoxelView.angles(look)
        }
        val view = VoxelView(o.eye.getOrElse(standing(world)), yaw, pitch, focal, o.look)
        view.camera(config)
        Seq(view)
    }
    VoxelScene(config, assets, world, views)
  }

  private def worldOf(o: VoxelOptions, size: WorldSize): (VoxelWorld, VoxelAssets) = {
    val assets = o.blocks.fold(Blocks.assets)(BlockFile.read)
    val vox = o.world.exists(_.toString.toLowerCase.endsWith(".vox"))
    for ((option, given) <- Seq("--crop" -> o.crop.isDefined, "--opaque" -> o.opaque) if given && !vox)
      throw InputError(s"$option: is for scenes of MagicaVoxel alone; give a .vox file with --world, or leave it out")
    o.world match {
      case Some(file) if vox =>
        if (o.blocks.isDefined && !assets.table.blocks.exists(_.opaque)) throw InputError(
          s"${o.blocks.get}: none of the blocks is opaque, so the voxels of $file have none; " +
            "set \"opaque\": true in one"
        )
        val notices = new Notices
        // A board that takes its world by the serial line has the blocks that it was built with.
        val keep = o.blocks.isDefined || o.serial.isDefined
        val options = VoxOptions(assets, o.crop, o.opaque, keep, grow = o.serial.isEmpty)
        val read = VoxFile.read(file, size, options, notices)
        notices.print()
        read
      case Some(file)                 => (VoxelWorld.readRaw(file, size, assets.table.blocks.length), assets)
      case None if o.blocks.isDefined =>
        throw InputError(
          "--blocks without --world: the hills are built of the workbench's own blocks; give a --world"
        )
      case None => (Hills(size, o.seed), assets)
    }
  }

  /** Eyes of a person in the middle of the world, on its highest block there. */
  private def standing(world: VoxelWorld): Vector3 = {
    val (x, y) = (world.size.x / 2, world.size.y / 2)
    Vector3(x + 0.5, y + 0.5, world.surface(x, y) + 2.6)
  }

  /** Views that the hardware takes, or InputError naming the line. */
  private def poses(file: String, text: String, focal: Double, config: VoxelConfig): Seq[VoxelView] = {
    val views = for ((line, i) <- text.linesIterator.toSeq.zipWithIndex if line.trim.nonEmpty) yield {
      line.trim.split("\\s+").map(_.toDoubleOption.filter(_.isFinite)) match {
        case Array(Some(x), Some(y), Some(z), Some(yaw), Some(pitch)) =>
          val view = VoxelView(Vector3(x, y, z), yaw, pitch, focal)
          try view.camera(config)
          catch { case InputError(message) => throw InputError(s"$file:${i + 1}: ${message.stripPrefix("--")}") }
          view
        case _ =>
          throw InputError(s"$file:${i + 1}: '${line.trim}' is no pose; write five numbers x y z yaw pitch")
      }
    }
    if (views.isEmpty) throw InputError(s"$file: has no pose; write lines of x y z yaw pitch")
    views
  }
}
