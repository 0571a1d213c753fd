package frustum.demos.voxel

import frustum.arithmetic.SineLookup
import frustum.contract.arithmetic.SineTable
import frustum.contract.voxel.{BlockTable, VoxelConfig}
import frustum.demos.voxel.VoxelRules._
import frustum.voxel.march.{CameraPort, PointedAt}
import frustum.voxel.world.{BlockEdit, WorldReadBus}
import spinal.core._
import spinal.lib._

/** A player in a world of blocks. At `frame` it takes the buttons: what they do to the block that is pointed at is
  * asked for by `edit`, which is ready when the world has it; then the player turns and moves, axis by axis, unless in the way there is a block that can be pointed
  * at; last, the camera of its eye is made. `done` pulses when all that holds, some 600 clocks after the edit. The model is
  * `frustum.model.demos.voxel.VoxelPlayer`.
  *
  * `place` puts the player somewhere, `load` replaces the camera until the next frame; neither may come during a frame.
  */
case class VoxelPlayer(
    c: VoxelConfig,
    rules: VoxelRules,
    kinds: BlockTable,
    program: CameraProgram,
    start: VoxelStart
) extends Component {
  require(rules.size == c.size, s"rules for a world of ${rules.size} in one of ${c.size}")
  val io = new Bundle {
    val frame = in Bool ()
    val buttons = in(VoxelButtons())
    val pointedAt = in(PointedAt(c))
    val place = slave(Flow(VoxelPose(c)))
    val load = slave(Flow(CameraPort(c)))
    val read = master(WorldReadBus(c))
    val edit = master(Stream(BlockEdit(c)))
    val pose = out(VoxelPose(c))
    val rise = out SInt (10 bits) // 1/256 block a picture, up is positive
    val item = out UInt (BlockTable.IdBits bits)
    val refused = out UInt (RefuseBits bits)
    val camera = out(CameraPort(c))
    val done = out Bool ()
  }
  private val width = VoxelPose.width(c)
  val pose = Reg(VoxelPose(c))
  for ((f, at) <- pose.feet.zip(start.feet.axes)) f.init(at)
  pose.yaw.init(start.yaw)
  pose.pitch.init(0)
  val rise = Reg(SInt(10 bits)) init 0
  val item = Reg(UInt(BlockTable.IdBits bits)) init 1
  val refused = Reg(UInt(RefuseBits bits)) init 0
  val held = Reg(VoxelButtons())
  held.flatten.foreach { case b: Bool => b.init(False) }
  val buttons = RegNextWhen(io.buttons, io.frame)
  io.pose := pose
  io.rise := rise
  io.item := item
  io.refused := refused

  /** One state after the other; a leg is the move along an axis, the third looks what is below, the fourth goes up or down. */
  object State extends SpinalEnum {
    val idle, aim, decide, edit, turn, sines, stuck, leg, settle, tries, probe, camera, done = newElement()
  }
  val state = RegInit(State.idle)
  val leg = Reg(UInt(2 bits))
  private def both(plus: Bool, minus: Bool): SInt =
    (plus && !minus).asUInt.resize(2).asSInt - (minus && !plus).asUInt.resize(2).asSInt

  val probe = BodyProbe(c, kinds)
  probe.io.read <> io.read
  probe.io.start := False
  val to = Reg(Vec(SInt(width bits), 3)) // where the player would like to be
  probe.io.feet := to

  /** The block that is placed lies before the face: a ray that goes up meets the bottom. */
  val hand = new Area {
    val at = io.pointedAt
    val axis = at.face >> 1
    val place = buttons.place && !held.place
    val target = Vec((0 to 2).map { k =>
      val block = at.block(k).resize(c.size.logs(k) + 2).asSInt
      Mux(axis === k, Mux(at.face.lsb, block + 1, block - 1), block).resize(c.blockBits)
    })
    val outside = (0 to 2).map(k => target(k).msb || (target(k) >> c.size.logs(k)) =/= 0).reduce(_ || _)
    val within = (0 to 2).map(k => target(k) >= probe.io.low(k) && target(k) <= probe.io.high(k)).reduce(_ && _)
    val destroy = buttons.destroy && !held.destroy
    val refuses = RegNext(outside || within)
    val block =
      Vec((0 to 2).map(k => Mux(destroy, at.block(k).resize(c.size.logs(k)), target(k).asUInt.resize(c.size.logs(k)))))
  }
  io.edit.valid := state === State.edit
  io.edit.address := RegNext(Cat((2 to 0 by -1).map(hand.block(_))).asUInt)
  io.edit.id := Mux(hand.destroy, U(0), item)

  val trig = new Area {
    val lookup = SineLookup()
    val sines = Reg(PlayerSines())
    val count = Reg(UInt(3 bits))
    lookup.io.angle := Mux(count(1), pose.pitch.asUInt, pose.yaw) + Mux(count(0), U(0), U(Turn / 4, AngleBits bits))
    when(state =/= State.sines)(count := 0) otherwise {
      count := count + 1
      for ((s, i) <- sines.all.zipWithIndex) when(count === i + 3)(s := lookup.io.sine)
    }
    val over = count === 7

    /** Rounded to 8 fraction bits. */
    private def coarse(s: SInt): SInt = RegNext((s + (1 << SineTable.FractionBits - 9)) >> SineTable.FractionBits - 8)
    private def times(by: SInt, s: SInt) =
      by.mux(S(1, 2 bits) -> s.resize(11), S(-1, 2 bits) -> -s.resize(11), default -> S(0, 11 bits))
    val (ahead, aside) = (both(buttons.forward, buttons.back), both(buttons.right, buttons.left))
    val (cos, sin) = (coarse(sines.cosYaw), coarse(sines.sinYaw))
    val sums = Vec(RegNext(times(ahead, cos) +^ times(aside, sin)), RegNext(times(ahead, sin) -^ times(aside, cos)))
    val steps = Vec(sums.map(s => RegNext((s * S(WalkStep, 7 bits)) >> 8).resize(width)))
  }
  val camera = PlayerCamera(c, program)
  camera.io.load << io.load
  camera.io.sines := trig.sines
  camera.io.start := False
  io.camera := camera.io.camera
  for (k <- 0 to 2) {
    val eye = if (k == 2) pose.feet(k) + EyeHeight else pose.feet(k)
    camera.io.eye(k) := (eye >> 8 - c.eyeBits).resize(c.blockBits + c.eyeBits)
  }

  /** Whether a body at `to` touches nothing, or the player stuck in a block already. */
  val stuck = Reg(Bool())
  val stands = Reg(Bool())
  val inRange = RegNext((0 to 2).map { k =>
    val (low, high) = rules.range(k); to(k) >= low && to(k) <= high
  }.reduce(_ && _))
  val lift = {
    val fall = rise - Gravity
    if (!rules.gravity) both(buttons.up, buttons.down).resize(10) * S(WalkStep, 7 bits)
    else
      Mux(stands && buttons.up, S(JumpSpeed), Mux(stands && rise <= 0, S(0), Mux(fall < -MostFall, S(-MostFall), fall)))
  }.resize(10)
  val change = leg.mux(0 -> trig.steps(0), 1 -> trig.steps(1), 2 -> S(-1, width bits), 3 -> lift.resize(width))

  private def arrive(free: Bool): Unit = {
    state := State.leg
    leg := leg + 1
    when(leg === 2)(stands := !free)
    when(leg =/= 2 && free)(pose.feet := to)
    when(leg === 3) {
      rise := Mux(free, lift, S(0))
      state := State.camera
      when(!free && lift < 0)(pose.feet(2)(7 downto 0) := 0)
    }
  }

  switch(state) {
    is(State.idle) {
      to := pose.feet
      when(io.frame) {
        probe.io.start := True
        state := State.aim
      }
    }
    is(State.aim)(when(probe.io.done)(state := State.decide))
    is(State.decide) {
      state := State.turn
      when(io.pointedAt.valid) {
        when(hand.destroy || hand.place && !hand.refuses)(state := State.edit)
        when(!hand.destroy && hand.place && hand.refuses && !refused.andR)(refused := refused + 1)
      }
    }
    is(State.edit)(when(io.edit.ready)(state := State.turn))
    is(State.turn) {
      held := buttons
      pose.yaw := pose.yaw + (both(buttons.turnLeft, buttons.turnRight) * S(TurnStep, 5 bits)).resize(AngleBits).asUInt
      val pitch = pose.pitch + (both(buttons.lookUp, buttons.lookDown) * S(LookStep, 5 bits)).resize(AngleBits)
      pose.pitch := Mux(pitch > MostPitch, S(MostPitch), Mux(pitch < -MostPitch, S(-MostPitch), pitch)).resized
      val (next, previous) = (buttons.next && !held.next, buttons.previous && !held.previous)
      when(next && !previous)(item := Mux(item === rules.items, U(1), item + 1).resized)
      when(previous && !next)(item := Mux(item === 1, U(rules.items), item - 1).resized)
      state := State.sines
    }
    is(State.sines)(when(trig.over) {
      probe.io.start := True
      state := State.stuck
    })
    is(State.stuck)(when(probe.io.done) {
      stuck := probe.io.touches
      leg := 0
      state := State.leg
    })
    is(State.leg) {
      to := pose.feet
      for (k <- 0 to 2) when(leg === k || Bool(k == 2) && leg === 3)(to(k) := pose.feet(k) + change)
      state := State.settle
    }
    is(State.settle)(state := State.tries)
    is(State.tries) {
      state := State.probe
      when(
        !inRange
      )(arrive(False)) elsewhen (Bool(!rules.collision) || stuck)(arrive(True)) otherwise (probe.io.start := True)
    }
    is(State.probe)(when(probe.io.done)(arrive(!probe.io.touches)))
    is(State.camera) {
      camera.io.start := True
      state := State.done
    }
    is(State.done)(when(camera.io.done)(state := State.idle))
  }
  io.done := RegNext(camera.io.done) init False
  when(io.place.valid) {
    pose := io.place.payload
    rise := 0
  }
}
