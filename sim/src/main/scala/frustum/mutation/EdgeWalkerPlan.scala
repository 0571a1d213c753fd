package frustum.mutation

import frustum.contract.raster.{RasterConfig, WalkerKind}
import frustum.mutation.MutationPlan.values
import frustum.raster.scan.EdgeWalker
import scala.util.Random

/** The edge walker, as `EdgeWalkerTest` has it: triangles of all families, loaded in random clocks. */
final class EdgeWalkerPlan(kind: WalkerKind) extends (Long => MutationPlan) {
  private val config = RasterConfig(walker = kind)

  def apply(seed: Long): MutationPlan = {
    val r = new Random(seed)
    val jobs = new EdgeJobs(config, r).families.flatMap { case (_, make) => make() }
    MutationPlan(
      s"EdgeWalker$kind",
      () => EdgeWalker(config),
      jobs.flatMap(steps(_, r)).toIndexedSeq,
      waitsFor = Some("io_idle"),
      stalled = Seq("io_up_ready"),
      event = Some((
        Seq("io_up_valid", "io_up_ready"),
        Seq("io_up_payload_end", "io_up_payload_y", "io_up_payload_first", "io_up_payload_last")
      )),
      events = jobs.flatMap { job =>
        job.spans.map(s => Seq(0, s.y, s.first, s.last).map(v => Some(BigInt(v)))) :+ Seq(
          Some(BigInt(1)),
          None,
          None,
          None
        )
      }.toIndexedSeq
    )
  }

  private def steps(job: EdgeJob, r: Random): Seq[MutationStep] = {
    val (stepAt, edgeAt) = EdgeJobs.times(r)
    // The screen's end is looked at with `start` alone: the next triangle may belong to a tile at another side.
    def other =
      values(
        "io_lastColumn" -> r.nextInt(config.tileWidth),
        "io_firstRow" -> r.nextInt(config.tileHeight),
        "io_lastRow" -> r.nextInt(config.tileHeight)
      )
    val load = (0 to edgeAt.last).map { clock =>
      val (step, edge) = (stepAt.indexOf(clock), edgeAt.indexOf(clock))
      val slope =
        if (step < 0) r.between(-65535, 65536) else (if (step % 2 == 0) job.stepX else job.stepY) (step / 2)
      MutationStep(
        other ++ values(
          "io_step_valid" -> (if (step < 0) 0 else 1),
          "io_step_payload" -> slope,
          "io_edge_valid" -> (if (edge < 0) 0 else 1),
          "io_edge_payload_index" -> edge.max(0),
          "io_edge_payload_value" -> (if (edge < 0) r.nextInt() else job.values(edge))
        )
      )
    }
    def idle(waits: Boolean) =
      MutationStep(
        other ++ values("io_step_payload" -> r.nextInt(), "io_edge_payload_value" -> r.nextInt()),
        waits = waits
      )
    val start = values(
      "io_start" -> 1,
      "io_lastColumn" -> job.lastColumn,
      "io_firstRow" -> job.firstRow,
      "io_lastRow" -> job.lastRow
    )
    load ++ Seq.fill(1 + r.nextInt(4))(idle(waits = false)) ++
      Seq(MutationStep(start), idle(waits = false), idle(waits = true))
  }
}

object EdgeWalkerPlan {
  val serial = new EdgeWalkerPlan(WalkerKind.Serial)
  val parallel = new EdgeWalkerPlan(WalkerKind.Parallel)
}
