package frustum.demos.voxel

import frustum.contract.voxel.{VoxelConfig, VoxelHostCommand}
import frustum.voxel.march.CameraWrite
import frustum.voxel.world.WorldWrite
import spinal.core._
import spinal.lib._

/** [[VoxelHost]] without a register of its own for the camera: its numbers are sent as they arrive, and `commit`
  * follows if the command is valid. A command with an error changes nothing and is counted, as there; so are blocks by
  * their id and places for a player, which have no hardware here.
  *
  * @param silence cycles after which the next byte begins a command
  */
case class CompactHost(config: VoxelConfig, silence: Int) extends Component {
  import VoxelHostCommand._
  val io = new Bundle {
    val bytes = slave(Stream(Bits(8 bits)))
    val edit = master(Stream(WorldWrite(config)))
    val camera = master(Flow(CameraWrite()))
    val commit = out Bool ()
    val highlight = out Bool () // valid with `commit`
    val refused = out UInt (8 bits) // refused commands; saturates
  }
  val framing = HostFraming(bytesOf, silence)
  val opcode = framing.io.opcode
  val payload = Reg(Bits(8 * WriteBytes bits))
  val third = Reg(UInt(2 bits)) // bytes of the current number
  val index = Reg(UInt(4 bits))
  val eyeFits = Reg(Bool())
  val editValid = RegInit(False) clearWhen io.edit.ready
  io.bytes.ready := !editValid
  io.refused := framing.io.refused
  framing.io.bytes << io.bytes.toFlowFire

  val (address, word) = (payload(47 downto 24).asUInt, payload(23 downto 0))
  val isCamera = opcode === Camera || opcode === Highlight
  val numberCame = RegNext(framing.io.payload.valid && third === 2, False)
  io.edit.valid := editValid
  io.edit.address := address.resized
  io.edit.word := word.resized
  io.camera.valid := numberCame && isCamera
  io.camera.index := RegNext(index)
  io.camera.value := word.asSInt

  when(framing.io.begins) {
    third := 0
    index := 0
    eyeFits := True
  }
  when(framing.io.payload.valid) {
    payload := payload(payload.high - 8 downto 0) ## framing.io.payload.payload
    third := third + 1
    when(third === 2) {
      third := 0
      index := index + 1
    }
  }
  when(numberCame && io.camera.index < 3 && !VoxelHost.eyeFits(config, io.camera.value))(eyeFits := False)

  io.commit := False
  io.highlight := opcode === Highlight
  framing.io.refuse := False
  when(framing.io.whole) {
    when(isCamera) {
      io.commit := eyeFits
      framing.io.refuse := !eyeFits
    } otherwise {
      val right = opcode === Write && address < config.size.blocks && (word >> config.leaps.wordBits) === 0
      editValid := right
      framing.io.refuse := !right
    }
  }
}
