package frustum.voxel

import frustum.spec.{VoxelConfig, VoxelHostCommand}
import spinal.core._
import spinal.lib._

/** [[VoxelHost]] without a register of its own for the camera: its numbers go on as they come, and `commit` says that they were all right. What is
  * wrong changes nothing and is counted, as there.
  *
  * @param silence clocks after which the next byte begins a command
  */
case class SerialHost(c: VoxelConfig, silence: Int) extends Component {
  import VoxelHostCommand._
  val io = new Bundle {
    val bytes   = slave(Stream(Bits(8 bits)))
    val edit    = master(Stream(WorldWrite(c)))
    val camera  = master(Flow(CameraWrite()))
    val commit  = out Bool ()
    val refused = out UInt (8 bits) // stays at its end
  }
  val payload   = Reg(Bits(8 * WriteBytes bits))
  val left      = Reg(UInt(log2Up(CameraBytes + 2) bits)) init 0 // bytes to come, the checksum among them
  val isCamera  = Reg(Bool())
  val third     = Reg(UInt(2 bits))                              // bytes of a number so far
  val index     = Reg(UInt(4 bits))
  val sum       = Reg(UInt(8 bits))
  val quiet     = Timeout(silence)
  val editValid = RegInit(False) clearWhen io.edit.ready
  val refused   = RegInit(U(0, 8 bits))
  val refuse    = False
  when(refuse && !refused.andR)(refused := refused + 1)

  val (address, word) = (payload(47 downto 24).asUInt, payload(23 downto 0))
  io.edit.valid   := editValid
  io.edit.address := address.resized
  io.edit.word    := word.resized
  io.refused      := refused
  io.bytes.ready  := !editValid
  io.camera.valid := RegNext(io.bytes.fire && isCamera && left > 1 && third === 2, False)
  io.camera.index := RegNext(index)
  io.camera.value := word.asSInt
  io.commit       := False

  when(io.bytes.fire) {
    quiet.clear()
    val byte = io.bytes.payload.asUInt
    sum := sum + byte
    when(left === 0) {
      sum      := byte
      third    := 0
      index    := 0
      isCamera := byte === Camera
      switch(byte) {
        is(Write)(left  := WriteBytes + 1)
        is(Camera)(left := CameraBytes + 1)
        default(refuse  := True)
      }
    } otherwise {
      left := left - 1
      when(left =/= 1) {
        payload := payload(payload.high - 8 downto 0) ## io.bytes.payload
        third   := third + 1
        when(third === 2) {
          third := 0
          index := index + 1
        }
      } elsewhen (sum + byte =/= 0) {
        refuse := True
      } elsewhen (isCamera) {
        io.commit := True
      } otherwise {
        val inside = address < c.size.blocks && (word >> c.leaps.wordBits) === 0
        editValid := inside
        refuse    := !inside
      }
    }
  } elsewhen (quiet && left =/= 0) {
    left   := 0
    refuse := True
  }
}
