package frustum.model.raster.link

import frustum.contract.raster.RasterConfig

/** The counters a host reads on MISO, in the order of [[frustum.raster.link.LinkStatus]], each modulo 256. */
final case class LinkCounters(
    accepted: Int,
    dropped: Int,
    verticesRefused: Int,
    trianglesRefused: Int,
    incomplete: Int,
    drawn: Int,
    trianglesUndrawn: Int
)

/** The way in as a whole: bytes of the wire to store, texel memory, jobs and counters, bit for bit as
  * [[frustum.raster.link.CommandLink]]; a host that heeds `cts` is assumed.
  */
final class LinkModel(config: RasterConfig) {
  val framer = new Framer
  val decoder = new CommandDecoder(config)

  def feed(bytes: Seq[Int]): Unit =
    for (byte <- bytes; (opcode, words) <- framer.take(byte)) decoder.execute(opcode, words)

  def jobs: Seq[Job] = decoder.jobs.toSeq

  /** @param drawn jobs done so far, @param undrawn triangles of theirs that face away or have no area */
  def counters(drawn: Int, undrawn: Int = 0): LinkCounters = {
    def wrap(count: Long) = (count & 0xff).toInt
    LinkCounters(
      wrap(decoder.accepted),
      wrap(framer.dropped + decoder.refused),
      wrap(decoder.verticesRefused),
      wrap(decoder.trianglesRefused),
      wrap(decoder.incomplete),
      wrap(drawn),
      wrap(undrawn)
    )
  }
}
