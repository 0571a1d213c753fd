package frustum.demos.voxel

import frustum.contract.voxel.{VoxelConfig, VoxelHostCommand}
import frustum.voxel.march.CameraPort
import spinal.core._
import spinal.lib._

/** Takes a host's commands, see [[frustum.contract.voxel.VoxelHostCommand]], and gives edits, cameras and places for
  * the player. A command with a wrong checksum, an unknown opcode, one cut short, an edit outside the world, an unknown
  * id, an eye or a place out of range change nothing and are counted. Bytes wait while an edit does; cameras and places
  * come a cycle after their last byte.
  *
  * @param silence cycles after which the next byte begins a command
  */
case class VoxelHost(config: VoxelConfig, rules: VoxelRules, silence: Int) extends Component {
  import VoxelHostCommand._
  val io = new Bundle {
    val bytes = slave(Stream(Bits(8 bits)))
    val edit = master(Stream(HostEdit(config)))
    val camera = master(Flow(CameraPort(config)))
    val highlight = out Bool () // valid with the camera
    val pose = master(Flow(VoxelPose(config)))
    val refused = out UInt (8 bits) // refused commands; saturates
  }
  val framing = HostFraming(bytesOf, silence)
  val opcode = framing.io.opcode
  val payload = Reg(Bits(8 * MostBytes bits))
  val edit = Reg(HostEdit(config))
  val editValid = RegInit(False) clearWhen io.edit.ready
  io.edit.valid := editValid
  io.edit.payload := edit
  io.bytes.ready := !editValid
  io.refused := framing.io.refused
  framing.io.bytes << io.bytes.toFlowFire
  framing.io.refuse := False
  when(framing.io.payload.valid)(payload := payload(payload.high - 8 downto 0) ## framing.io.payload.payload)

  private def number(n: Int, of: Int) = payload(24 * (of - 1 - n), 24 bits).asSInt

  private val camera = io.camera.payload
  private val fields =
    camera.eye.toSeq ++ Seq(camera.look, camera.base, camera.right, camera.down).flatMap(_.axes)
  for ((field, n) <- fields.zipWithIndex) field := number(n, 15).resized
  val cameraAllowed = RegNext((0 to 2).map(n => VoxelHost.eyeFits(config, number(n, 15))).reduce(_ && _))
  val cameraDone = False
  io.camera.valid := RegNext(cameraDone) init False // the payload is stable until the second byte after it
  io.highlight := opcode === Highlight

  private val pose = Vec((0 until 5).map(number(_, 5)))
  private val allowed = (0 to 2).map(rules.range) :+ ((0, VoxelRules.Turn - 1)) :+
    ((-VoxelRules.MostPitch, VoxelRules.MostPitch))
  val poseAllowed = RegNext(Vec(pose.zip(allowed).map { case (v, (low, high)) => v >= low && v <= high }).andR)
  for (k <- 0 to 2) io.pose.feet(k) := pose(k).resized
  io.pose.yaw := pose(3).asUInt.resized
  io.pose.pitch := pose(4).resized
  val poseDone = False
  io.pose.valid := RegNext(poseDone) init False

  val (address, content) = (number(0, 2).asUInt, number(1, 2).asUInt)
  val editAllowed = RegNext(
    address < config.size.blocks &&
      Mux(opcode === Block, content <= rules.items, (content >> config.leaps.wordBits) === 0)
  )

  when(framing.io.whole) {
    when(opcode === Player) {
      poseDone := poseAllowed
      framing.io.refuse := !poseAllowed
    } elsewhen (opcode === Camera || opcode === Highlight) {
      cameraDone := cameraAllowed
      framing.io.refuse := !cameraAllowed
    } otherwise {
      edit.address := address.resized
      edit.content := content.asBits.resized
      edit.byId := opcode === Block
      editValid := editAllowed
      framing.io.refuse := !editAllowed
    }
  }
}

object VoxelHost {

  /** Whether a component of an eye, as a host sends it, is not cut by the width of an eye. */
  def eyeFits(config: VoxelConfig, number: SInt): Bool =
    number === number.resize(config.blockBits + config.eyeBits).resize(number.getWidth)
}
