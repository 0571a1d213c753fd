package frustum.demos.voxel

import frustum.arithmetic.SerialMultiplier
import frustum.contract.arithmetic.SineTable
import frustum.contract.voxel.{VoxelCamera, VoxelConfig}
import frustum.demos.voxel.CameraProgram._
import frustum.voxel.march.{CameraPort, Direction}
import spinal.core._
import spinal.lib._

/** Sines and cosines of a player's yaw and pitch. */
case class PlayerSines() extends Bundle {
  val cosYaw, sinYaw, cosPitch, sinPitch = SInt(SineTable.Width bits)
  def all: Seq[SInt] = Seq(cosYaw, sinYaw, cosPitch, sinPitch) // as CameraProgram.sines has them
}

/** Makes a camera's directions of the sines of its angles, a step of [[frustum.demos.voxel.CameraProgram]] in about
  * twenty cycles with one multiplier that adds and shifts. Sines must be stable from `start` to `done`. A host may
  * `load` a camera instead.
  */
case class PlayerCamera(config: VoxelConfig, program: CameraProgram) extends Component {
  import PlayerCamera._
  val io = new Bundle {
    val start = in Bool ()
    val sines = in(PlayerSines())
    val eye = in Vec (SInt(config.blockBits + config.eyeBits bits), 3) // in blocks, eyeBits fraction bits
    val load = slave(Flow(CameraPort(config)))
    val camera = out(CameraPort(config))
    val done = out Bool ()
  }
  val camera = Reg(CameraPort(config))
  private val vectors = Seq(camera.look, camera.base, camera.right, camera.down)
  io.camera := camera

  private def sine(s: Sine): SInt = io.sines.all(CameraProgram.sines.indexOf(s))
  private def fine(s: Sine): SInt = wide(sine(s) << VoxelCamera.DirectionBits - SineTable.FractionBits)
  private def value(v: Value): SInt = v match {
    case s: Sine => fine(s)
    case p: Part => vectors(p.vector).axes(p.axis)
  }
  private def number(f: Factor): SInt = f match {
    case s: Sine => sine(s)
    case _       => S(program.factor(f, _ => 0), FactorBits bits)
  }

  /** Number of the step that is made; `added` is high in the last of its cycles. */
  val step = Reg(UInt(log2Up(steps.length) bits)) init 0
  val last = step === steps.length - 1
  val added = False
  val begin = RegNext(io.start || added && !last) init False
  when(added)(step := step + 1)
  when(io.start)(step := 0)

  /** One operand of a step: a choice among those that occur. */
  private def choice[A, T <: Data](of: Step => A)(make: A => T): T = {
    val kinds = steps.map(of).distinct
    Vec(kinds.map(make))(Vec(steps.map(s => U(kinds.indexOf(of(s)), log2Up(kinds.length) bits)))(step))
  }
  private def wide(v: SInt) = v.resize(VoxelCamera.DirectionWidth)

  val multiplier = SerialMultiplier(VoxelCamera.DirectionWidth, FactorBits)
  multiplier.io.a := RegNext(choice(_.value)(value))
  multiplier.io.b := RegNext(choice(_.factor)(number))
  multiplier.io.start := RegNext(begin) init False

  // A register behind the shift and one behind the rounding: `RoundingCycles`.
  val moved = RegNext(choice(s => program.shift(s.factor)) { n =>
    (multiplier.io.product >> n - 1).resize(VoxelCamera.DirectionWidth + 1)
  })
  val product = RegNext((moved + 1) >> 1)
  val from = RegNext(choice(_.start)(_.fold(S(0, VoxelCamera.DirectionWidth bits))(value)))
  added setWhen Delay(multiplier.io.done, RoundingCycles, init = False)

  val result = from + Mux(choice(_.minus)(Bool(_)), -wide(product), wide(product))
  for (target <- steps.map(_.target).distinct; port = vectors(target.vector).axes(target.axis)) when(
    added && choice(_.target == target)(Bool(_))
  )(port := result)
  io.done := RegNext(added && last) init False
  when(io.start) {
    camera.eye := io.eye
    camera.look.axes(2) := fine(SinPitch)
    camera.right.axes(2) := 0
  }
  when(io.load.valid)(camera := io.load.payload)
}

object PlayerCamera {
  private val RoundingCycles = 2
}
