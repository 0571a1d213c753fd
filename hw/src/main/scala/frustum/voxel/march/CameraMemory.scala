package frustum.voxel.march

import frustum.contract.voxel.{VoxelCamera, VoxelConfig}
import spinal.core._
import spinal.lib._

/** A number of a camera: eye, look, base, right, down, three components each, numbered in this order. */
case class CameraWrite() extends Bundle {
  val index = UInt(4 bits)
  val value = SInt(VoxelCamera.DirectionWidth bits)
}

/** Cameras in block RAM: the one that is drawn with, the newest complete one, and one that is being written. `commit`
  * makes the written one the newest, `take` draws with the newest. Numbers come [[CameraMemory.Latency]] cycles after
  * their request; the eye can be requested a second time.
  *
  * @param initial the camera until another is committed after a reset; it has a bank of its own, which nothing writes
  */
case class CameraMemory(config: VoxelConfig, initial: VoxelCamera) extends Component {
  val io = new Bundle {
    val write = slave(Flow(CameraWrite()))
    val commit = in Bool ()
    val take = in Bool ()
    val index = in UInt (4 bits)
    val value = out SInt (VoxelCamera.DirectionWidth bits)
    val axis = in UInt (2 bits)
    val eye = out SInt (config.blockBits + config.eyeBits bits)
  }
  val shown, newest = RegInit(U(0, 2 bits)) // banks; 0 is that of the initial camera
  val written = RegInit(U(1, 2 bits)) // the bank of 1 to 3 that is neither of these two
  val next = Mux(io.take, newest, shown)
  shown := next
  when(io.commit) {
    newest := written
    written := written ^ Mux(next === 0, U(3), next) // the third of 1, 2, 3; until the first is taken 1 and 2 in turn
  }

  /** The undefined registers after power up must not select the bank of the initial camera. */
  private val enable = io.write.valid && written =/= 0
  private def memory(width: Int) = {
    val numbers = initial.numbers.padTo(16, 0)
    val mem = Mem(
      Bits(width bits),
      Seq.fill(4)(numbers).flatten.map(n => B(BigInt(n) & ((BigInt(1) << width) - 1), width bits))
    )
    mem.write(written @@ io.write.index, io.write.value.resize(width).asBits, enable)
    mem
  }
  val all = memory(VoxelCamera.DirectionWidth)
  val eyes = memory(io.eye.getWidth)
  io.value := all.readSync(shown @@ io.index).asSInt
  io.eye := eyes.readSync(shown @@ io.axis.resize(4)).asSInt
}

object CameraMemory {

  /** Cycles from a number's index to the number. */
  val Latency = 1

  // Numbers at which the vectors begin.
  val Eye = 0
  val Look = 3
  val Base = 6
  val Right = 9
  val Down = 12
}
