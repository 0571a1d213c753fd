package frustum.bench

import frustum.engine.raster.{DrawnPass, PipelineEvent}

/** What a triangle costs, from a frame with copies of it one after the other: the clocks from one copy's being handed
  * over to the next's, summed over the tiles that its box touches. So set-up and drawing overlap as they do in a stream
  * of such triangles, and the display's share, sending a finished tile, is left out: it is hidden as long as a tile's
  * drawing takes longer. There are no more copies than triangles kept set up, so a copy is set up in its first tile and
  * moved to the others. The first copies of each tile fill the pipeline and do not count.
  *
  * @param firstTile clocks in the first tile, @param others in each further tile, in order
  */
final case class TriangleCost(firstTile: Double, others: Seq[Double]) {
  def total: Double = firstTile + others.sum
}

object TriangleCost {

  /** Copies a frame, as many as the pipeline keeps set up. */
  val Copies = 4

  /** None for a triangle without area or wholly off the screen, of which nothing is handed over. */
  def of(pass: DrawnPass): Option[TriangleCost] = {
    val jobs = pass.events.filter(e => Set(PipelineEvent.Moved, PipelineEvent.Missed, PipelineEvent.TileEnd)(e.kind))
    val tiles = split(jobs).filter(_.length == Copies).map { tile =>
      (tile.last.time - tile(1).time).toDouble / (Copies - 2)
    }
    tiles.headOption.map(TriangleCost(_, tiles.tail))
  }

  private def split(jobs: Seq[PipelineEvent]): Seq[Seq[PipelineEvent]] =
    if (jobs.isEmpty) Nil
    else {
      val (tile, rest) = jobs.span(_.kind != PipelineEvent.TileEnd)
      tile +: split(rest.drop(1))
    }
}
