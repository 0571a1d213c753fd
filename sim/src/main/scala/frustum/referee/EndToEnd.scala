package frustum.referee

/** What a referee found in a picture, or in several.
  *
  * @param referee        `llvmpipe` or `world`
  * @param judged         pixels that are not within 1/8 pixel of an edge
  * @param primitiveWrong of these, another triangle of the scene shows
  * @param texelsWrong    pixels with the right triangle, judged, not within 1/64 texel of a border, that show another
  *   texel
  * @param primitiveUnexplained,texelsUnexplained of these, what vertices on 1/16 pixel and depths of 16 bits do not
  *                       account for, see [[WorldPicture.explains]]
  * @param colorWrong     judged pixels with the right triangle and texel in another colour, see
  *   [[WorldPicture.sameColor]]
  * @param refereesDiffer judged pixels at which llvmpipe, in float32, and float64 show different triangles or texels:
  *                       not counted as wrong
  */
final case class EndToEnd(
    referee: String,
    judged: Long,
    primitiveWrong: Long,
    texelsWrong: Long,
    primitiveUnexplained: Long,
    texelsUnexplained: Long,
    colorWrong: Long,
    refereesDiffer: Long
) {
  def +(o: EndToEnd): EndToEnd = EndToEnd(
    if (o.referee == referee) referee else s"$referee, ${o.referee}",
    judged + o.judged,
    primitiveWrong + o.primitiveWrong,
    texelsWrong + o.texelsWrong,
    primitiveUnexplained + o.primitiveUnexplained,
    texelsUnexplained + o.texelsUnexplained,
    colorWrong + o.colorWrong,
    refereesDiffer + o.refereesDiffer
  )

  /** What no quantisation accounts for, in per cent of the judged pixels. */
  def unexplainedPercent: Double =
    100.0 * (primitiveUnexplained + texelsUnexplained + colorWrong) / judged.max(1)
}

object EndToEnd {

  /** @param seen,rgb what the hardware shows, and its picture as 0xRRGGBB
    * @param other     llvmpipe's drawing where there is one
    */
  def judge(world: WorldPicture, other: Option[Seen], seen: Seen, rgb: Array[Int]): EndToEnd = {
    val truth = world.seen
    var judged, primitive, texels, primitiveWorse, texelsWorse, colors, differ = 0L
    for (at <- rgb.indices if world.judged(at)) {
      judged += 1
      val agreed = other.forall { o =>
        o.samePrimitives(truth, at) && (o.sameTexels(truth, at) || !world.texelsJudged(at))
      }
      if (!agreed) differ += 1
      else if (!seen.samePrimitives(truth, at)) {
        primitive += 1
        val accounted =
          world.explains(at, truth.opaque(at), seen.opaque(at)) && world.explains(at, truth.top(at), seen.top(at))
        if (!accounted) primitiveWorse += 1
      } else if (!seen.sameTexels(truth, at)) {
        if (world.texelsJudged(at)) texels += 1
        if (
          !explained(world, at, truth.opaque(at), seen.opaqueTexel(at)) || !explained(
            world,
            at,
            truth.top(at),
            seen.topTexel(at)
          )
        ) texelsWorse += 1
      } else if (world.sameColor(at, rgb(at)).contains(false)) colors += 1
    }
    val referee = if (other.isDefined) Llvmpipe.Name else World
    EndToEnd(referee, judged, primitive, texels, primitiveWorse, texelsWorse, colors, differ)
  }

  private def explained(world: WorldPicture, at: Int, triangle: Int, texel: Int) =
    triangle < 0 || world.explainsTexel(at, triangle, texel)

  val World = "world"
}
