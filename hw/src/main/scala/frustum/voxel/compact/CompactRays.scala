package frustum.voxel.compact

import frustum.arithmetic.Multiplier16
import frustum.contract.arithmetic.ReciprocalTable
import frustum.contract.voxel.{VoxelCamera, VoxelConfig}
import frustum.device.Tech
import frustum.voxel.march.{CameraMemory, PixelOrder, RayStart, VoxelRay}
import spinal.core._
import spinal.lib._

/** What [[PixelRays]] and [[VoxelRaySetup]] do, with one adder of directions, one multiplier and directions kept in block RAM: a ray in 11 clocks.
  *
  * After `start` the camera must hold until `busy` falls. The ray that picks goes first; the others wait until `picked`, and each of them
  * until there is `room` for its pixel, whose number, modulo 512, goes on from frame to frame. The models are those of the two units.
  */
case class CompactRays(c: VoxelConfig, tech: Tech) extends Component {
  import CameraMemory._
  val io = new Bundle {
    val start = in Bool ()
    val picked = in Bool ()
    val room = in Bool ()
    val busy = out Bool ()
    val begun = out Bool () // once a ray
    val index = out UInt (4 bits)
    val value = in SInt (VoxelCamera.DirectionWidth bits)
    val pixel = out UInt (PixelOrder.TagBits bits) // the next one to begin
    val down = master(Stream(RayStart(c)))
  }
  private val width = VoxelCamera.DirectionWidth

  /** Clock within a ray: 0 to 4 its direction, to 8 the reciprocal of its greatest component; then, while the next ray begins, `late` to 12 the
    * slopes, to 15 where it starts.
    */
  val clock = RegInit(U(0, 4 bits))
  val late = RegInit(U(0, 4 bits))

  /** Which ray is made. */
  val scan = new Area {
    val picking, waiting, scanning = RegInit(False)
    val column = Reg(UInt(log2Up(c.width) bits))
    val row = Reg(UInt(log2Up(c.height) bits))
    val pixel = RegInit(U(0, PixelOrder.TagBits bits))
    val first = column === 0 && !picking // of its row
    val done = clock === 8 // its direction is not needed any more
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
        when(column === c.width - 1) {
          column := 0
          row := row + 1
          when(row === c.height - 1)(scanning := False)
        }
      }
    }
  }

  val ray = Reg(VoxelRay(c))
  val at = Reg(Vec(SInt(c.blockBits + c.fractionBits bits), 2))
  val past = Reg(Bits(2 bits))
  val plane = Reg(SInt(c.blockBits bits))
  val downValid = RegInit(False) clearWhen io.down.ready

  val free = !downValid || io.down.ready
  val runs = clock.mux(
    0 -> ((scan.picking || scan.scanning && io.room) && (late <= 10 || late === 15)), // apart from eyes read at 13 and 14
    5 -> (late === 0 && free),
    default -> True
  )
  when(runs)(clock := Mux(clock === 8, U(0), clock + 1))
  when(late =/= 0)(late := late + 1)
  when(clock === 8)(late := 9)
  private def during(n: Int) = clock === n && runs

  /** Directions, as they were for this row's first pixel (0 to 2) and as they are (4 to 6). */
  val directions = Mem(SInt(width bits), 8)
  val fast = Reg(UInt(2 bits))
  val mirrored = Reg(Bits(3 bits))
  private def axis(i: Int) =
    ray.fast.mux(0 -> U(i % 3, 2 bits), 1 -> U((i + 1) % 3, 2 bits), default -> U((i + 2) % 3, 2 bits))
  val stepping = clock < 5
  val from = Mux(stepping, scan.first || scan.column === 1 && !scan.picking, scan.first)
  val wanted = clock.mux(6 -> axis(1), 7 -> axis(2), default -> clock(1 downto 0))
  val before = directions.readSync(!from ## wanted.asBits asUInt)
  val eyeAxis = Mux(late === 13, axis(1), Mux(late === 14, axis(2), axis(0)))
  io.index := Mux(
    late === 13 || late === 14 || clock === 8,
    eyeAxis.resize(4),
    (Mux(
      scan.picking,
      U(Look, 4 bits),
      Mux(scan.first, Mux(scan.row === 0, U(Base, 4 bits), U(Down, 4 bits)), U(Right, 4 bits))
    ) + clock(1 downto 0))
  )

  /** A component at a time, from the clock after it was read: its magnitude, and which was the greatest so far. */
  val direction = new Area {
    val begins = RegNext(scan.picking || scan.first && scan.row === 0)
    val read = RegNext(Mux(stepping, io.value + Mux(begins, S(0, width bits), before), before))
    val magnitude = read.abs.resize(width - 1)
    val major = Reg(UInt(width - 1 bits))
    val tells = clock >= 2 && clock <= 4
    val k = (clock - 2)(1 downto 0)
    directions.write(!scan.first ## k.asBits asUInt, read, tells)
    when(tells) {
      mirrored(k) := read.msb
      when(clock === 2 || magnitude > major) {
        major := magnitude
        fast := k
      }
    }
    when(during(5)) {
      ray.fast := fast
      ray.mirrored := mirrored
      ray.pick := scan.picking
      ray.pixel := scan.pixel.resized
    }
  }

  val multiplier = Multiplier16(tech, signedA = false, signedB = false, add = true, hold = true)
  multiplier.io.enable := True
  multiplier.io.holdA := late === 9 || late === 10
  val product = multiplier.io.product

  val slopes = new Area {
    val half = !direction.major.msb
    val f = Mux(half, direction.major(20 downto 1), direction.major(21 downto 2))
    val lines = Mem(
      Bits(32 bits),
      (0 until 256).map(i => B(ReciprocalTable.base(i).toLong << 13 | ReciprocalTable.slope(i), 32 bits))
    )
    val word = lines.readSync(f(19 downto 12))
    val scaled = Vec(Reg(UInt(16 bits)), 2)
    val minor = direction.magnitude
    when(clock === 8 || late === 9) {
      scaled(0) := scaled(1)
      scaled(1) := Mux(half, minor(21 downto 6), minor(22 downto 7))
    }
    val quotient = Mux(late(0), scaled(0), scaled(1)) - product(31 downto 17).asUInt
    val slope = (Mux(quotient.msb, U(0x7fff, 15 bits), quotient(14 downto 0)) >> 15 - c.slopeBits)
    when(late === 11)(ray.slopes(0) := slope)
    when(late === 12)(ray.slopes(1) := slope)
  }

  val entry = new Area {
    val which = late(0).asUInt // the second of the others at 13 and 15
    val k = late.mux(9 -> axis(0), 14 -> axis(1), default -> axis(2))
    val value = io.value.resize(c.blockBits + c.eyeBits)
    val size = k.mux((0 to 2).map(i =>
      i -> S(c.size.axes(i) << c.eyeBits, c.blockBits + c.eyeBits bits)
    ) :+ (default -> S(0, c.blockBits + c.eyeBits bits)): _*)
    val place = Mux(ray.mirrored(k), size - value, value)
    val behind = Reg(UInt(c.eyeBits bits))
    when(late === 9) {
      plane := place >> c.eyeBits
      behind := place(c.eyeBits - 1 downto 0).asUInt
    }
    val after = Vec(ray.fast =/= 2, ray.fast === 0) // whether the axis comes after the fast one
    for (i <- 0 to 1) ray.low(i) := after(i) && ray.slopes(i) =/= 0
    val position = (place ## B(0, c.slopeBits bits)).asSInt -
      (product(c.fractionBits downto 0).asUInt + ray.low(which).asUInt).resize(c.fractionBits + 2).asSInt
    for (i <- 0 to 1) when(late === 14 + i) {
      at(i) := position
      past(i) := (position >> c.fractionBits) =/= (place >> c.eyeBits)
    }
    when(late === 15)(downValid := True)
  }

  multiplier.io.a := Mux(
    clock === 6,
    slopes.word(12 downto 0).resize(16),
    Mux(clock === 8, product(31 downto 16), Mux(late === 12, ray.slopes(0), ray.slopes(1)).asBits.resize(16))
  )
  multiplier.io.b := Mux(
    clock === 6,
    slopes.f(11 downto 0).asBits.resize(16),
    Mux(late === 12 || late === 13, entry.behind.asBits.resize(16), slopes.scaled(1).asBits)
  )
  multiplier.io.addend := Mux(clock === 6, slopes.word(31 downto 13) ## B(0, 13 bits), B(0, 32 bits))

  val end = new Area {
    val steep = Vec((0 to 1).map(i => ray.slopes(i)(c.slopeBits - 1 downto c.slopeBits - 3)))
    val slabs = Vec(c.slabs.map(n => U(n, 7 bits)))(steep(1) @@ steep(0))
    io.down.end := plane.resize(c.endBits) + slabs.resize(c.endBits).asSInt
  }
  io.down.valid := downValid
  io.down.ray := ray
  io.down.place.plane := plane
  io.down.place.at := at
  io.down.place.past := past
}
