package frustum.engine

/** Something that draws: float64, bit-exact model, or simulated hardware. All works of one call have the same
  * configuration, so that an engine is built and loaded once.
  *
  * @tparam Work what a frame is made from
  * @tparam Frame what is known of a frame once it is drawn
  */
trait Engine[-Work, +Frame] {

  /** Draws one frame per work, in order, and hands each of them over. The next work is taken when the frame before has
    * been handed over, and may depend on it; an engine that takes works ahead says so.
    */
  def draw(works: Iterator[Work])(each: Frame => Unit): Unit

  /** The frames of works that are known beforehand. */
  final def drawAll(works: Seq[Work]): Seq[Frame] = {
    val frames = Seq.newBuilder[Frame]
    draw(works.iterator)(frames += _)
    frames.result()
  }
}
