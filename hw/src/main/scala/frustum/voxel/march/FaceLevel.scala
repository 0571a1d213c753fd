package frustum.voxel.march

import frustum.contract.voxel.{FaceLight, VoxelConfig}
import spinal.core._

/** Tables of [[frustum.contract.voxel.FaceLight]], whose index begins with a face's level: which of the different
  * lights it is in.
  */
object FaceLevel {
  val Bits = 2
  private val lights = VoxelConfig.Light.distinct
  require(lights.length <= (1 << Bits), s"${lights.length} different lights of faces; at most ${1 << Bits}")

  def of(face: UInt): UInt = {
    def level(n: Int) = U(n, Bits bits)
    val levels = VoxelConfig.Light.zipWithIndex.map { case (light, f) => f -> level(lights.indexOf(light)) }
    face.mux(levels :+ (default -> level(0)): _*)
  }

  /** What is lit, by level and a texel's channel. */
  val lit: Seq[Int] =
    for (level <- 0 until 1 << Bits; channel <- 0 to 15) yield FaceLight.lit(channel, lights.lift(level).getOrElse(0))
}
