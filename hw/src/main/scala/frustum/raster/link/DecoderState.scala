package frustum.raster.link

import spinal.core._

/** States of [[CommandDecoder]]; `hand` is handing the job over, `range` judges the tiles that `region` brought. */
object DecoderState extends SpinalEnum(binaryOneHot) {
  val header, dispatch, skip, finish = newElement()
  val begin, frame, color, region, range = newElement()
  val renderState, loadState, firstVertex, loadVertex = newElement()
  val fetchFirst, fetchSecond, writeState, writeVertex = newElement()
  val load, read, response, settle, axisDone, writeIndices, writeBox = newElement()
  val texelAddress, loadTexel, texel = newElement()
  val drawVertices, drawTriangles, compare, hand = newElement()
}
