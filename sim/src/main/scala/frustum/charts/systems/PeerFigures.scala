package frustum.charts.systems

import frustum.contract.InputError
import java.nio.file.{Files, Path}

/** Measured figures of the compared system, as its column of docs/results.md gives them: ranges, least and greatest.
  *
  * @param name what the column calls it
  */
final case class PeerFigures(
    name: String,
    clockMHz: (Double, Double),
    logicCells: (Double, Double),
    cubeCycles: (Double, Double),
    cyclesPerPixel: (Double, Double),
    quadTexelsWrong: (Double, Double),
    floorTexelsWrong: (Double, Double)
) {

  /** Frames a second from cycles a frame, at the slowest clock and most cycles, and at the fastest and least. */
  def framesPerSecond(cycles: (Double, Double)): (Double, Double) =
    (clockMHz._1 * 1e6 / cycles._2, clockMHz._2 * 1e6 / cycles._1)

  /** Of the full-screen quad. */
  def quadCycles(pixels: Int): (Double, Double) = (cyclesPerPixel._1 * pixels, cyclesPerPixel._2 * pixels)
}

object PeerFigures {
  val Document: Path = Path.of("docs", "results.md")
  private val Column = "Rasterix"

  def read(document: Path = Document): PeerFigures = {
    val rows =
      Files.readString(document).linesIterator.filter(_.startsWith("|")).map(_.split('|').map(_.trim).toSeq).toSeq

    /** The cell in the column of the row that has this word, of the table that the row belongs to. */
    def figures(word: String): (Double, Double) = {
      val at = rows.indexWhere(_.exists(_.contains(word)))
      val column = if (at < 0) -1 else rows.take(at).findLast(_.contains(Column)).fold(-1)(_.indexOf(Column))
      val numbers = rows.lift(at).flatMap(_.lift(column)).toSeq
        .flatMap(cell => "[0-9][0-9,]*(\\.[0-9]+)?".r.findAllIn(cell).map(_.replace(",", "").toDouble))
      if (numbers.isEmpty) throw InputError(
        s"$document: no figure of $Column in a row with '$word'; the charts take the peers' points from there"
      )
      (numbers.head, numbers.take(2).last)
    }
    PeerFigures(
      Column,
      figures("`clockMHz.min`"),
      figures("`logicCells`"),
      figures("`cubeClocksPerFrame`"),
      figures("`fullScreenClocksPerPixel`"),
      figures("wrong texels, full-screen quad"),
      figures("wrong texels, floor")
    )
  }
}
