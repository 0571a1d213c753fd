package frustum.demos.voxel

import frustum.contract.arithmetic.SineTable
import frustum.contract.raster.Part
import scala.math.{floor, log, pow, round}

/** How a camera follows from the sines and cosines of its yaw and pitch: one product per step,
  * {{{
  * look  = (cos yaw cos pitch, sin yaw cos pitch, sin pitch)
  * right = (sin yaw, -cos yaw, 0) / focal
  * down  = (cos yaw sin pitch, sin yaw sin pitch, -cos pitch) / focal
  * base  = look - (width - 1) / 2 right - (height - 1) / 2 down
  * }}}
  * Numbers are those of [[VoxelCamera]]. As rays add up rounded steps, `base` is computed from the rounded `right` and
  * `down`; sines of 16 fraction bits turn the whole camera by at most 1/500 pixel.
  *
  * @param focal pixels from the eye to the screen
  */
final case class CameraProgram(width: Int, height: Int, focal: Double) {
  import CameraProgram._
  require(focal >= 16 && focal <= 8192, s"a screen $focal pixels away; 16 to 8192 are supported")

  /** 1 / focal is `scale` / 2^scaleShift, the scale of 16 bits. */
  val scaleShift: Int = FactorBits - 2 + floor(log(focal) / log(2)).toInt
  val scale: Int = round(pow(2, scaleShift) / focal).toInt

  def factor(f: Factor, sines: Sine => Int): Int = f match {
    case s: Sine => sines(s)
    case Scale   => scale
    case Columns => width - 1
    case Rows    => height - 1
  }

  /** Bits that a product with the factor is moved down by, rounded. */
  def shift(f: Factor): Int = f match {
    case _: Sine => SineTable.FractionBits
    case Scale   => scaleShift
    case _       => 1
  }
}

object CameraProgram {

  /** Signed. */
  val FactorBits = SineTable.Width

  sealed trait Value
  sealed trait Factor

  /** A value of 22 fraction bits that is a factor as well. */
  sealed trait Sine extends Value with Factor
  case object CosYaw extends Sine
  case object SinYaw extends Sine
  case object CosPitch extends Sine
  case object SinPitch extends Sine
  case object Scale extends Factor
  case object Columns extends Factor
  case object Rows extends Factor

  /** A component of the camera. */
  final case class Part(vector: Int, axis: Int) extends Value
  private val Seq(look, base, right, down) = (0 until 4).map(v => (axis: Int) => Part(v, axis))

  /** target = start, if there is one, plus or minus value * factor. */
  final case class Step(target: Part, value: Value, factor: Factor, minus: Boolean = false, start: Option[Value] = None)

  /** Sines in the order in which they are looked up, with what is added to the angle. */
  val sines: Seq[Sine] = Seq(CosYaw, SinYaw, CosPitch, SinPitch)

  /** `look` along z is the sine of pitch, `right` along z is 0: no step makes them. */
  val steps: Seq[Step] = Seq(
    Step(look(0), CosYaw, CosPitch),
    Step(look(1), SinYaw, CosPitch),
    Step(right(0), SinYaw, Scale),
    Step(right(1), CosYaw, Scale, minus = true),
    Step(down(0), CosYaw, SinPitch),
    Step(down(1), SinYaw, SinPitch),
    Step(down(0), down(0), Scale),
    Step(down(1), down(1), Scale),
    Step(down(2), CosPitch, Scale, minus = true),
    Step(base(0), right(0), Columns, minus = true, Some(look(0))),
    Step(base(1), right(1), Columns, minus = true, Some(look(1))),
    Step(base(0), down(0), Rows, minus = true, Some(base(0))),
    Step(base(1), down(1), Rows, minus = true, Some(base(1))),
    Step(base(2), down(2), Rows, minus = true, Some(SinPitch))
  )
}
