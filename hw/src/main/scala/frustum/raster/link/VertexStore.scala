package frustum.raster.link

import frustum.contract.raster.{RasterConfig, StoreLayout, StoredVertex}
import frustum.raster.store.FieldBits._
import spinal.core._
import spinal.lib._

/** Puts vertices into the store under the frame's tag. One that is out of range leaves its slot with the tag of another
  * frame, and the words from the first error on unchanged.
  */
case class VertexStore(config: RasterConfig) extends Component {
  val layout = StoreLayout(config)
  val io = new Bundle {
    val tag = in Bits (StoredVertex.Tag.width bits)
    val up = slave(Stream(VertexWord(config)))
    val writes = master(Stream(StoreWrite(layout)))
  }
  private val tagWord = StoredVertex.Tag.slice.word
  val isTag = io.up.word === tagWord
  val write = StoreWrite(layout)
  write.address := StoreAddress.vertex(layout, io.up.index, io.up.word)
  write.data := io.up.data
  when(isTag)(StoredVertex.Tag.put(write.data, io.tag ^ (io.up.fault ## B(0, io.tag.getWidth - 1 bits))))
  io.writes << io.up.throwWhen(io.up.beyond || io.up.fault && !isTag).translateWith(write)
}
