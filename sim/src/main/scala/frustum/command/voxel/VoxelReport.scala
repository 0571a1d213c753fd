package frustum.command.voxel

import frustum.BuildInfo
import frustum.command.common.Clock
import frustum.contract.voxel.VoxelConfig
import frustum.engine.voxel.VoxelEngineEntry
import frustum.files.{InfinityAsNull, OutputFile}
import frustum.judge.{Psnr, VoxelCounts}
import java.nio.file.Path

/** The JSON report of `voxel`, and of the world of blocks in `demo`: sums over the views, times per view. */
object VoxelReport {
  def json(
      command: String,
      seed: Long,
      engine: VoxelEngineEntry,
      c: VoxelConfig,
      views: Seq[ViewFigures]
  ): ujson.Obj = {
    val report = ujson.Obj(
      "command" -> command,
      "version" -> BuildInfo.version,
      "seed" -> seed.toDouble,
      "engine" -> engine.name,
      "scene" -> "voxel",
      "width" -> c.width,
      "height" -> c.height,
      "frames" -> views.length
    )
    sum(views).foreach { n =>
      report("rays") = n.rays.toDouble
      report("steps") = n.steps.toDouble
      report("stepsPerRay") = n.steps.toDouble / n.rays
      report("plainSteps") = n.plainSteps.toDouble
      if (views.forall(_.cycles.isDefined)) {
        val clock = Clock.ofTop(engine.top)
        val clocks = views.flatMap(_.cycles).sum.toDouble
        report("clocksPerFrame") = clocks / views.length
        report("clocksPerStep") = clocks / n.steps
        report("framesPerSecond") = clock.mhz * 1e6 * views.length / clocks
        if (views.forall(_.cyclesAtPins.isDefined)) {
          val atPins = views.flatMap(_.cyclesAtPins).sum.toDouble
          report("clocksPerFrameAtPins") = atPins / views.length
          report("framesPerSecondAtPins") = clock.mhz * 1e6 * views.length / atPins
          report("raysPerSecond") = clock.mhz * 1e6 * n.rays / clocks
          report("raysPerSecondAtPins") = clock.mhz * 1e6 * n.rays / atPins
        }
        report("clockMHz") = clock.mhz
        report("clockSource") = clock.source
      }
      report("blocksWrong") = n.blocksWrong.toDouble
      report("facesWrong") = n.facesWrong.toDouble
      report("texelsWrong") = n.texelsWrong.toDouble
      report("maxDirectionErrorPixels") = n.maxDirectionErrorPixels
    }
    report("psnr") =
      InfinityAsNull.write(Psnr.of(views.map(_.squaredError).sum, c.pixels.toLong * views.length))
    if (views.forall(_.pixelsDifferent.isDefined))
      report("hardwareVsModel") =
        ujson.Obj("pixelsDifferent" -> views.flatMap(_.pixelsDifferent).sum.toDouble)
    report
  }

  private def sum(views: Seq[ViewFigures]): Option[VoxelCounts] = views.flatMap(_.counts).reduceOption(_ + _)

  /** Writes the report and says what must be zero and is not; gives the exit code. */
  def write(file: Path, report: ujson.Obj, views: Seq[ViewFigures]): Int = {
    OutputFile.writeText(file, ujson.write(report, indent = 2) + "\n")
    val different = views.flatMap(_.pixelsDifferent).sum
    val failures = sum(views).toSeq.flatMap(_.failures) ++
      Option.when(different > 0)(s"$different pixels of the hardware are not the model's")
    failures.foreach(f => Console.err.println(s"error: voxel: $f; see $file"))
    if (failures.isEmpty) 0 else 1
  }
}
