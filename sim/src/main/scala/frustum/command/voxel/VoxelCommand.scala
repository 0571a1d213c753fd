package frustum.command.voxel

import frustum.command.common.{Arguments, CommandLine, Progress, ReportTable}
import frustum.contract.voxel.VoxelHostCommand
import frustum.files.OutputFile
import frustum.model.voxel.world.LeapWords
import frustum.picture.Picture
import java.nio.file.{Files, Path}
import scala.collection.mutable

/** `voxel`: views of a world of blocks, each ray judged against exact marching. */
object VoxelCommand extends CommandLine {
  val name = "voxel"
  val summary = "draws a world of blocks; writes out/voxel/voxel.png and a report"

  def run(args: Seq[String]): Int =
    Arguments.parse(name, VoxelOptions.parser, args, VoxelOptions()).fold(0)(voxel)

  private def voxel(o: VoxelOptions): Int = {
    val scene = VoxelScenes(o)
    import scene.{config, views}
    val judged = new JudgedViews(scene, o.engine, o.highlight, o.seed)
    OutputFile.check((fileOf(o, 0) +: o.reportFile +: o.serial.toSeq): _*)
    println(
      s"voxel: ${views.length} view(s) of a world of ${config.size}, ${config.width}x${config.height}, ${o.engine.name}"
    )
    val drawn = mutable.ArrayBuffer.empty[ViewFigures]
    val progress = Progress("voxel", views.length)
    try judged.draw { view =>
        val file = fileOf(o, drawn.length)
        Picture.writePng(file, config.width, config.height, view.picture)
        drawn += view.figures
        progress.step()
      }
    finally progress.close()
    val report = VoxelReport.json(name, o.seed, o.engine, config, drawn.toSeq)
    println(ReportTable(Seq(report)))
    val code = VoxelReport.write(o.reportFile, report, drawn.toSeq)
    o.serial.foreach(writeSerial(_, scene))
    println(s"wrote ${fileOf(o, 0)}${if (views.length > 1) " and so on" else ""} and ${o.reportFile}")
    code
  }

  /** Every word of the world's memory, then the camera. */
  private def writeSerial(file: Path, scene: VoxelScene): Unit = {
    val words = LeapWords(scene.world, scene.config.leaps).zipWithIndex.iterator
      .flatMap { case (word, address) => VoxelHostCommand.write(address, word) }
    val bytes = words ++ VoxelHostCommand.camera(scene.views.last.camera(scene.config))
    OutputFile.write(file)(part => Files.write(part, bytes.map(_.toByte).toArray))
    println(s"wrote $file")
  }

  /** Numbered where there are several. */
  private def fileOf(o: VoxelOptions, n: Int): Path = {
    val name = o.out.getFileName.toString
    val numbered =
      if (o.path.isEmpty || name.contains("%d")) name else name.replaceFirst("(\\.[^.]*)?$", "-%d$1")
    o.out.resolveSibling(numbered.replace("%d", n.toString))
  }
}
