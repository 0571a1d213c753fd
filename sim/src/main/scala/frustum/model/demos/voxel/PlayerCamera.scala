package frustum.model.demos.voxel

import frustum.contract.arithmetic.{IntVector, SineTable}
import frustum.contract.voxel.{VoxelCamera, VoxelConfig}
import frustum.demos.voxel.{CameraProgram, VoxelRules}
import frustum.demos.voxel.CameraProgram.{CosPitch, CosYaw, Part, Sine, SinPitch, SinYaw, Value}

/** The camera of a player's eye: [[frustum.demos.voxel.CameraProgram]], interpreted. */
object PlayerCamera {
  def apply(p: VoxelPlayer, c: VoxelConfig, program: CameraProgram): VoxelCamera = {
    val sines = Map[Sine, Int](
      CosYaw -> SineTable.sine(p.yaw + VoxelRules.Turn / 4),
      SinYaw -> SineTable.sine(p.yaw),
      CosPitch -> SineTable.sine(p.pitch + VoxelRules.Turn / 4),
      SinPitch -> SineTable.sine(p.pitch)
    )
    val fine = VoxelCamera.DirectionBits - SineTable.FractionBits
    val start = Map[Value, Int](Part(0, 2) -> (sines(SinPitch) << fine), Part(2, 2) -> 0) ++
      sines.map { case (s, v) => (s: Value) -> (v << fine) }
    val values = CameraProgram.steps.foldLeft(start) { (now, step) =>
      val shift = program.shift(step.factor)
      val product = (now(step.value).toLong * program.factor(step.factor, sines) + (1L << shift - 1)) >> shift
      now + (step.target -> (step.start.fold(0)(now) + (if (step.minus) -product else product).toInt))
    }
    def vector(v: Int) = IntVector(values(Part(v, 0)), values(Part(v, 1)), values(Part(v, 2)))
    val blind = 8 - c.eyeBits // bits of the player's place that the eye has not
    VoxelCamera(
      IntVector(p.eye.x >> blind, p.eye.y >> blind, p.eye.z >> blind),
      vector(0),
      vector(1),
      vector(2),
      vector(3)
    )
  }
}
