package frustum.voxel

import frustum.spec.{VoxelConfig, VoxelHostCommand}
import spinal.core._
import spinal.lib._

/** Takes a host's commands, see [[frustum.spec.VoxelHostCommand]], and gives edits and the camera. A command with a wrong checksum, an unknown
  * opcode, one cut short, and an edit outside the world change nothing and are counted. Bytes wait while an edit does.
  *
  * @param initial the camera until the host sends one
  * @param silence clocks after which the next byte begins a command
  */
case class VoxelHost(c: VoxelConfig, initial: frustum.spec.VoxelCamera, silence: Int) extends Component {
  import VoxelHostCommand._
  val io = new Bundle {
    val bytes   = slave(Stream(Bits(8 bits)))
    val edit    = master(Stream(WorldWrite(c)))
    val camera  = out(CameraPort(c))
    val refused = out UInt (8 bits) // stays at its end
  }
  val payload   = Reg(Bits(8 * CameraBytes bits))
  val left      = Reg(UInt(log2Up(CameraBytes + 2) bits)) init 0 // bytes to come, the checksum among them
  val isCamera  = Reg(Bool())
  val sum       = Reg(UInt(8 bits))
  val quiet     = Timeout(silence)
  val edit      = Reg(WorldWrite(c))
  val editValid = RegInit(False) clearWhen io.edit.ready
  val camera    = Reg(CameraPort(c))
  val refused   = RegInit(U(0, 8 bits))
  val refuse    = False
  when(refuse && !refused.andR)(refused := refused + 1)

  io.edit.valid   := editValid
  io.edit.payload := edit
  io.camera       := camera
  io.refused      := refused
  io.bytes.ready  := !editValid

  private def number(n: Int, of: Int) = payload(8 * 3 * (of - 1 - n), 24 bits).asSInt
  private val fields                  =
    camera.eye.toSeq ++ Seq(camera.look, camera.base, camera.right, camera.down).flatMap(_.axes)
  private val values =
    Seq(initial.eye, initial.look, initial.base, initial.right, initial.down).flatMap(_.axes)
  for ((field, value) <- fields.zip(values)) field.init(S(value, field.getWidth bits))

  when(io.bytes.fire) {
    quiet.clear()
    val byte = io.bytes.payload.asUInt
    sum := sum + byte
    when(left === 0) {
      sum      := byte
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
      } elsewhen (sum + byte =/= 0) {
        refuse := True
      } elsewhen (isCamera) {
        for ((field, n) <- fields.zipWithIndex) field := number(n, 15).resized
      } otherwise {
        val (address, word) = (number(0, 2).asUInt, number(1, 2).asBits)
        edit.address := address.resized
        edit.word    := word.resized
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
