package frustum.raster.link

import frustum.contract.raster.{RasterConfig, TexelsHeadLayout}
import frustum.raster.store.FieldBits._
import frustum.raster.texture.TexelWrite
import spinal.core._
import spinal.lib._

/** Executes `texels`, once nothing is being drawn. What runs beyond the memory is not written, and the command refused.
  */
case class TexelCommand(config: RasterConfig) extends Component {
  val io = new Bundle {
    val up = slave(GroupPort())
    val drawing = in Bool ()
    val texels = master(Stream(TexelWrite()))
  }
  private val texelBits = log2Up(config.textureTexels)
  private val unitBits = log2Up(TexelsHeadLayout.Unit)
  private val blockBits = texelBits - unitBits
  val group = io.up.group
  val unit = TexelsHeadLayout.Address.in(group.single)
  val noSuchUnit = RegNext(unit(15 downto blockBits).orR)
  val address = Reg(UInt(texelBits + 1 bits)) // the most significant bit: beyond the memory
  val fits = address < config.textureTexels

  io.texels.valid := group.valid && !group.first && fits
  io.texels.address := address.resized
  io.texels.data := group.single
  group.ready := Mux(group.first, noSuchUnit || !io.drawing, io.texels.ready || !fits)
  io.up.refuse := Mux(group.first, noSuchUnit, !fits)

  when(group.valid && group.first)(address := (unit(blockBits - 1 downto 0) << unitBits).asUInt.resized)
  when(io.texels.fire)(address := address + 1)
}
