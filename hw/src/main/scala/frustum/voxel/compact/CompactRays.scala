package frustum.voxel.compact

import frustum.arithmetic.{Multiplier16, ReciprocalLine}
import frustum.contract.voxel.{VoxelCamera, VoxelConfig}
import frustum.device.Tech
import frustum.voxel.march.{CameraMemory, PixelOrder, RayAxes, RayEntry, RaySlope, RayStart, VoxelRay}
import spinal.core._
import spinal.lib._

/** What [[PixelRays]] and [[VoxelRaySetup]] do, with one adder of directions, one multiplier and directions kept in
  * block RAM: 11 cycles per ray.
  *
  * After `start` the camera must hold until `busy` falls. The ray that picks goes first; the others wait until
  * `picked`, and each of them until there is `room` for its pixel, whose number, modulo 512, continues from frame to
  * frame. The models are those of the two units.
  */
case class CompactRays(config: VoxelConfig, tech: Tech = Tech.Generic) extends Component {
  import CameraMemory._
  import CompactRaySteps._
  val io = new Bundle {
    val start = in Bool ()
    val picked = in Bool ()
    val room = in Bool ()
    val busy = out Bool ()
    val begun = out Bool () // pulses once per ray
    val index = out UInt (4 bits)
    val value = in SInt (VoxelCamera.DirectionWidth bits)
    val pixel = out UInt (PixelOrder.TagBits bits) // the number of the next pixel to begin
    val down = master(Stream(RayStart(config)))
  }
  private val width = VoxelCamera.DirectionWidth

  /** Up to the reciprocal; then, while the next ray begins, the `late` steps. */
  val step = RegInit(U(Begin, 4 bits))
  val late = RegInit(U(Idle, LateBits bits))

  /** Which ray is made. */
  val scan = new Area {
    val picking, waiting, scanning = RegInit(False)
    val column = Reg(UInt(log2Up(config.width) bits))
    val row = Reg(UInt(log2Up(config.height) bits))
    val pixel = RegInit(U(0, PixelOrder.TagBits bits))
    val first = column === 0 && !picking // the first pixel of its row
    val done = step === Reciprocal // the direction is no longer needed
    io.begun := done
    io.busy := picking || waiting || scanning
    io.pixel := pixel
    when(io.start && !io.busy)(picking := True)
    when(waiting && io.picked) {
      waiting := False
      scanning := True
      column := 0
      row := 0
    }
    when(done) {
      when(picking) {
        picking := False
        waiting := True
      } otherwise {
        pixel := pixel + 1
        column := column + 1
        when(column === config.width - 1) {
          column := 0
          row := row + 1
          when(row === config.height - 1)(scanning := False)
        }
      }
    }
  }

  val ray = Reg(VoxelRay(config))
  val at = Reg(Vec(SInt(config.blockBits + config.fractionBits bits), 2))
  val past = Reg(Bits(2 bits))
  val plane = Reg(SInt(config.blockBits bits))
  val downValid = RegInit(False) clearWhen io.down.ready

  /** While the eye is read, no direction can be. */
  val unasked = late <= AskEye(0) - Axes || late === AskEye(1) + 1
  val free = !downValid || io.down.ready
  val runs = step.mux(
    Begin -> ((scan.picking || scan.scanning && io.room) && unasked),
    Fast -> (late === Idle && free),
    default -> True
  )
  when(runs)(step := Mux(step === Reciprocal, U(Begin), step + 1))
  when(late =/= Idle)(late := late + 1)
  when(step === Reciprocal)(late := MultiplySlope(0))

  /** Directions, as they were for this row's first pixel (0 to 2) and as they are (4 to 6). */
  val directions = Mem(SInt(width bits), 8)
  val fast = Reg(UInt(2 bits))
  val mirrored = Reg(Bits(3 bits))
  private def axis(i: Int) = RayAxes.number(ray.fast, i)
  val stepping = step < Fast
  val from = Mux(stepping, scan.first || scan.column === 1 && !scan.picking, scan.first)
  val wanted = step.mux(AskOther(0) -> axis(1), AskOther(1) -> axis(2), default -> step(1 downto 0))
  val before = directions.readSync(!from ## wanted.asBits asUInt)
  val eyeAxis = Mux(late === AskEye(0), axis(1), Mux(late === AskEye(1), axis(2), axis(0)))
  val asksEye = late === AskEye(0) || late === AskEye(1) || step === AskFastEye
  private def number(n: Int) = U(n, 4 bits)
  val begins = Mux(scan.row === 0, number(Base), number(Down)) // the first direction of a row
  val vector = Mux(scan.picking, number(Look), Mux(scan.first, begins, number(Right)))
  io.index := Mux(asksEye, eyeAxis.resize(4), vector + step(1 downto 0))

  /** A component at a time: its magnitude, and which was the greatest so far. */
  val direction = new Area {
    val begins = RegNext(scan.picking || scan.first && scan.row === 0)
    val read = RegNext(Mux(stepping, io.value + Mux(begins, S(0, width bits), before), before))
    val magnitude = read.abs.resize(RaySlope.MagnitudeBits)
    val major = Reg(UInt(RaySlope.MagnitudeBits bits))
    val tells = step >= Component && step < Fast
    val k = (step - Component)(1 downto 0)
    directions.write(!scan.first ## k.asBits asUInt, read, tells)
    when(tells) {
      mirrored(k) := read.msb
      when(step === Component || magnitude > major) {
        major := magnitude
        fast := k
      }
    }
    when(step === Fast && runs) {
      ray.fast := fast
      ray.mirrored := mirrored
      ray.pick := scan.picking
      ray.pixel := scan.pixel.resized
    }
  }

  val multiplier = Multiplier16(tech, signedA = false, signedB = false, add = true, hold = true)
  multiplier.io.enable := True
  multiplier.io.holdA := late === MultiplySlope(0) || late === MultiplySlope(1) // the reciprocal
  val product = multiplier.io.product

  /** The lowest bit of `late` distinguishes the other axes' steps. */
  private def which[T <: Data](steps: Int => Int)(first: T, second: T): T =
    if (steps(0) % 2 == 0) Mux(late(0), second, first) else Mux(late(0), first, second)

  val slopes = new Area {
    val f = RaySlope.mantissa(direction.major)
    val line = ReciprocalLine.read(f)
    val scaled = Vec(Reg(UInt(16 bits)), 2)
    when(step === Other(0) || late === MultiplySlope(0)) {
      scaled(0) := scaled(1)
      scaled(1) := RaySlope.scaled(direction.magnitude, direction.major)
    }
    val slope = RaySlope(config, which(Slope)(scaled(0), scaled(1)), product)
    for (i <- 0 to 1) when(late === Slope(i))(ray.slopes(i) := slope)
  }

  val entry = new Area {
    val k = late.mux(MultiplySlope(0) -> axis(0), Position(0) -> axis(1), default -> axis(2))
    val eye = RayAxes.mirroredEye(config, ray.mirrored, io.value.resize(config.blockBits + config.eyeBits), k)
    val behind = Reg(UInt(config.eyeBits bits))
    when(late === MultiplySlope(0)) {
      plane := RayEntry.plane(config, eye)
      behind := RayEntry.behind(config, eye)
    }
    for (i <- 0 to 1) ray.low(i) := RayEntry.low(ray.fast, ray.slopes(i), i)
    val position = RayEntry.at(config, eye, product, which(Position)(ray.low(0), ray.low(1)))
    for (i <- 0 to 1) when(late === Position(i)) {
      at(i) := position
      past(i) := RayEntry.past(config, position, eye)
    }
    when(late === Position(1))(downValid := True)
  }

  val operands = new Area {
    val corrects = step === MultiplyLine
    val slope = Mux(late === MultiplyBack(0), ray.slopes(0), ray.slopes(1)).asBits.resize(16)
    val goesBack = late === MultiplyBack(0) || late === MultiplyBack(1)
    multiplier.io.a := Mux(
      corrects,
      slopes.line.factor,
      Mux(step === Reciprocal, ReciprocalLine.reciprocal(product), slope)
    )
    multiplier.io.b := Mux(
      corrects,
      ReciprocalLine.fraction(slopes.f),
      Mux(goesBack, entry.behind.asBits.resize(16), slopes.scaled(1).asBits)
    )
    multiplier.io.addend := Mux(corrects, slopes.line.addend, B(0, 32 bits))
  }

  io.down.valid := downValid
  io.down.ray := ray
  io.down.place.plane := plane
  io.down.place.at := at
  io.down.place.past := past
  io.down.end := RayEntry.end(config, plane, ray.slopes)
}
