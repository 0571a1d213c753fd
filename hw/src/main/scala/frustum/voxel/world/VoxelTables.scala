package frustum.voxel.world

import frustum.contract.voxel.{BlockTable, VoxelTextures}
import spinal.core._

/** A texel's RGBA4444, one per cycle, latency [[VoxelTables.Latency]] cycles: texture by id and face, colour index by
  * texel, colour by texture and index.
  */
case class VoxelTables(kinds: BlockTable, textures: VoxelTextures) extends Component {
  val io = new Bundle {
    val id = in UInt (BlockTable.IdBits bits)
    val face = in UInt (3 bits)
    val u, v = in UInt (4 bits)
    val rgba = out Bits (16 bits)
  }
  private def rom(bits: Int, words: Seq[Int]) = Mem(Bits(bits bits), words.map(B(_, bits bits)))
  private def each(of: IndexedSeq[IndexedSeq[Int]], size: Int) =
    (0 until VoxelTextures.Most).flatMap(t => if (t < of.length) of(t) else Seq.fill(size)(0))

  val byId = rom(
    5,
    (0 to BlockTable.Most).flatMap { id =>
      (0 until 8).map(f => if (kinds.ids.contains(id) && f < 6) kinds(id).textures(f) else 0)
    }
  )
  val number = byId.readSync(io.id @@ io.face)
  val index = rom(4, each(textures.indices, 256)).readSync((number ## RegNext(io.v) ## RegNext(io.u)).asUInt)
  io.rgba := rom(16, each(textures.palettes, 16)).readSync((RegNext(number) ## index).asUInt)
}

object VoxelTables {

  /** Three memories, one after the other. */
  val Latency = 3
}
