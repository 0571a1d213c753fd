package frustum.link

import spinal.core._

/** States of [[CommandDecoder]]; `hand` is handing the job over, `commonState` the render state of triangles. */
object DecoderState extends SpinalEnum {
  val header, dispatch, skip, finish = newElement()
  val begin, frame, color, regionX, regionY = newElement()
  val stateIndex, commonState, firstVertex, loadVertex = newElement()
  val fetchFirst, fetchSecond, writeState, writeVertex = newElement()
  val load, read, response, settle, axisDone, writeIndices, writeBox = newElement()
  val texelAddress, loadTexel, texel = newElement()
  val drawVertices, drawTriangles, compare, hand = newElement()
}
