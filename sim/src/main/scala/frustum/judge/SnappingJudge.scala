package frustum.judge

import frustum.driver.raster.PreparedFrame
import frustum.reference.raster.{ReferenceRaster, Shading}
import scala.collection.mutable.ArrayBuffer

/** A frame against the driver's own vertices before they were rounded: what rounding costs. The driver itself is judged
  * by [[EndToEndJudge]].
  *
  * @param coverageWrong layers too many or too few, summed over pixels
  * @param texelsWrong   textured layers that read another texel, of pixels with the right number of layers
  */
final case class SnappingVerdict(coverageWrong: Long, texelsWrong: Long) {
  def +(o: SnappingVerdict): SnappingVerdict =
    SnappingVerdict(coverageWrong + o.coverageWrong, texelsWrong + o.texelsWrong)
}

/** Compares layer by layer in drawing order, because snapping moves an edge, and with it a pixel, from one
  * triangle to its neighbour without anything to be seen.
  */
object SnappingJudge {
  private type Layers = Array[ArrayBuffer[Option[(Int, Int)]]]

  /** @param fragments of each pass
    * @return the verdict, and the picture it was judged against as 0xRRGGBB
    */
  def judge(frame: PreparedFrame, fragments: Seq[Iterable[LoggedFragment]]): (SnappingVerdict, Array[Int]) = {
    val width = frame.config.width
    def empty: Layers = Array.fill(width * frame.config.height)(ArrayBuffer.empty)
    val (drawn, truth) = (empty, empty)
    for ((pass, log) <- frame.passes.zip(fragments); f <- log) {
      val textured = Shading.textureOf(pass.states(pass.triangles(f.triangle).state)).isDefined
      drawn(f.y * width + f.x) += Option.when(textured)((f.texelS, f.texelT))
    }
    val reference = ReferenceRaster.drawEndToEnd(frame, f => truth(f.y * width + f.x) += f.texel)
    val verdict = drawn.zip(truth).foldLeft(SnappingVerdict(0, 0)) { case (sum, (mine, its)) =>
      if (mine.length != its.length) sum + SnappingVerdict((mine.length - its.length).abs, 0)
      else sum + SnappingVerdict(0, mine.zip(its).count { case (a, b) => a.isDefined && a != b })
    }
    (verdict, reference.rgb888)
  }
}
