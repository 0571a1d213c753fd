package frustum.voxel.compact

import frustum.arithmetic.{Multiplier16, ReciprocalLine}
import frustum.voxel.march.CameraMemory

/** Schedule of [[CompactRays]]: the steps at which a word is requested, arrives, or enters the multiplier. */
private[voxel] object CompactRaySteps {
  val Axes = 3

  // Steps of a direction, whose components are requested, arrive from the camera, and are added to those of the pixel
  // before.
  val Begin = 0
  val Component = Begin + CameraMemory.Latency + 1
  val Fast = Component + Axes

  // Steps of the reciprocal of the greatest component, while the two others are read again from the memory of
  // directions and go through the register behind it.
  val MultiplyLine = Fast + ReciprocalLine.Latency
  val Reciprocal = MultiplyLine + Multiplier16.Latency
  val AskOther: Int => Int = Fast + 1 + _
  val Other: Int => Int = AskOther(_) + 2
  val AskFastEye = Reciprocal

  // Late steps, of the other axes one after the other: slopes, then positions at the ray's start. 0 is none.
  val Idle = 0
  val MultiplySlope: Int => Int = Reciprocal + 1 + _
  val Slope: Int => Int = MultiplySlope(_) + Multiplier16.Latency
  val MultiplyBack: Int => Int = Slope(_) + 1
  val Position: Int => Int = MultiplyBack(_) + Multiplier16.Latency
  val AskEye: Int => Int = Position(_) - CameraMemory.Latency

  /** After its last step the counter of late steps is 0 again. */
  val LateBits = 4
  require(Position(1) == (1 << LateBits) - 1, s"late steps end with ${Position(1)}")
  require(Other(0) == Reciprocal, s"the other axes come at ${Other(0)}, the reciprocal at $Reciprocal")
}
