package frustum.demos.voxel

import frustum.contract.voxel.{BlockTable, VoxelConfig}
import frustum.demos.voxel.VoxelRules._
import frustum.voxel.march.{CameraPort, PointedAt}
import frustum.voxel.world.{BlockEdit, WorldReadBus}
import spinal.core._
import spinal.lib._
import spinal.lib.fsm._

/** A player in a world of blocks. At `frame` it takes the buttons: the change of the selected block is requested by
  * `edit`, which is ready when it is made. Then the player turns and moves, axis by axis, unless a selectable block is
  * in the path. Last, the camera of its eye is computed. `done` pulses about 600 cycles after the edit. The model is
  * `frustum.model.demos.voxel.VoxelPlayer`.
  *
  * `place` sets the player's place, `load` replaces the camera until the next frame; neither may come during a frame.
  */
case class VoxelPlayer(
    config: VoxelConfig,
    rules: VoxelRules,
    kinds: BlockTable,
    program: CameraProgram,
    start: VoxelStart
) extends Component {
  require(rules.size == config.size, s"rules for a world of ${rules.size} in one of ${config.size}")
  val io = new Bundle {
    val frame = in Bool ()
    val buttons = in(VoxelButtons())
    val pointedAt = in(PointedAt(config))
    val place = slave(Flow(VoxelPose(config)))
    val load = slave(Flow(CameraPort(config)))
    val read = master(WorldReadBus(config))
    val edit = master(Stream(BlockEdit(config)))
    val pose = out(VoxelPose(config))
    val rise = out SInt (10 bits) // 1/256 block per picture, up is positive
    val item = out UInt (BlockTable.IdBits bits)
    val refused = out UInt (RefuseBits bits)
    val camera = out(CameraPort(config))
    val done = out Bool ()
  }
  private val width = VoxelPose.width(config)
  val pose = Reg(VoxelPose(config))
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

  val leg = Reg(UInt(2 bits))
  val probe = BodyProbe(config, kinds)
  probe.io.read <> io.read
  probe.io.start := False
  val to = Reg(Vec(SInt(width bits), 3)) // the place after the next leg
  probe.io.feet := to

  /** One state after the other, those from `move` to `probes` once a leg: along x, along y, a probe of what is below,
    * and up or down.
    */
  val fsm = new StateMachine {
    val idle = makeInstantEntry()
    val aim, decide, edit = new State
    val turn, sines, here = new State
    val move, settle, tries, probes = new State
    val view, done = new State

    /** @param free a body at `to` touches nothing */
    private def arrive(free: Bool): Unit = {
      leg := leg + 1
      goto(move)
      when(leg === 2)(stands := !free)
      when(leg =/= 2 && free)(pose.feet := to)
      when(leg === 3) {
        rise := Mux(free, lift, S(0))
        when(!free && lift < 0)(pose.feet(2)(7 downto 0) := 0)
        goto(view)
      }
    }
    idle.whenIsActive {
      to := pose.feet
      when(io.frame) {
        probe.io.start := True
        goto(aim)
      }
    }
    aim.whenIsActive(when(probe.io.done)(goto(decide)))
    decide.whenIsActive {
      goto(turn)
      when(io.pointedAt.valid) {
        when(destroys || places && !hand.refuses)(goto(edit))
        when(!destroys && places && hand.refuses && !refused.andR)(refused := refused + 1)
      }
    }
    edit.whenIsActive(when(io.edit.ready)(goto(turn)))
    turn.whenIsActive {
      held := buttons
      pose.yaw := pose.yaw + turned(buttons.turnLeft, buttons.turnRight, TurnStep).asUInt
      val pitch = pose.pitch + turned(buttons.lookUp, buttons.lookDown, LookStep)
      pose.pitch := Mux(pitch > MostPitch, S(MostPitch), Mux(pitch < -MostPitch, S(-MostPitch), pitch)).resized
      val (next, previous) = (buttons.next && !held.next, buttons.previous && !held.previous)
      when(next && !previous)(item := Mux(item === rules.items, U(1), item + 1).resized)
      when(previous && !next)(item := Mux(item === 1, U(rules.items), item - 1).resized)
      goto(sines)
    }
    sines.whenIsActive(when(walk.over) {
      probe.io.start := True
      goto(here)
    })
    here.whenIsActive(when(probe.io.done) {
      stuck := probe.io.touches
      leg := 0
      goto(move)
    })
    move.whenIsActive {
      to := pose.feet
      for (k <- 0 to 2) when(leg === k || Bool(k == 2) && leg === 3)(to(k) := pose.feet(k) + change)
      goto(settle)
    }
    settle.whenIsActive(goto(tries))
    tries.whenIsActive {
      goto(probes)
      when(!inRange)(arrive(False))
        .elsewhen(Bool(!rules.collision) || stuck)(arrive(True))
        .otherwise(probe.io.start := True)
    }
    probes.whenIsActive(when(probe.io.done)(arrive(!probe.io.touches)))
    view.whenIsActive {
      camera.io.start := True
      goto(done)
    }
    done.whenIsActive(when(camera.io.done)(goto(idle)))
    always(when(io.place.valid) {
      pose := io.place.payload
      rise := 0
    })
  }
  val destroys = buttons.destroy && !held.destroy
  val places = buttons.place && !held.place
  val hand: PlayerHand = new PlayerHand(config, io.pointedAt, destroys, probe.io.low, probe.io.high)
  io.edit.valid := fsm.isActive(fsm.edit)
  io.edit.address := hand.address
  io.edit.id := Mux(destroys, U(0), item)

  val walk: PlayerSteps = new PlayerSteps(width, pose, buttons, looks = fsm.isActive(fsm.sines))
  val camera = PlayerCamera(config, program)
  camera.io.load << io.load
  camera.io.sines := walk.sines
  camera.io.start := False
  io.done := RegNext(camera.io.done) init False
  io.camera := camera.io.camera
  for (k <- 0 to 2) {
    val eye = if (k == 2) pose.feet(k) + EyeHeight else pose.feet(k)
    camera.io.eye(k) := (eye >> 8 - config.eyeBits).resize(config.blockBits + config.eyeBits)
  }

  private def turned(plus: Bool, minus: Bool, step: Int): SInt =
    (VoxelButtons.both(plus, minus) * S(step, 5 bits)).resize(AngleBits)

  val stuck = Reg(Bool()) // the body touches a block before it moves
  val stands = Reg(Bool()) // the body is on a block
  val inRange = RegNext((0 to 2).map { k =>
    val (low, high) = rules.range(k)
    to(k) >= low && to(k) <= high
  }.reduce(_ && _))
  val lift = {
    val fall = rise - Gravity
    if (!rules.gravity) VoxelButtons.both(buttons.up, buttons.down).resize(10) * S(WalkStep, 7 bits)
    else {
      val falls = Mux(stands && rise <= 0, S(0), Mux(fall < -MostFall, S(-MostFall), fall))
      Mux(stands && buttons.up, S(JumpSpeed), falls)
    }
  }.resize(10)
  val change = leg.mux(0 -> walk.steps(0), 1 -> walk.steps(1), 2 -> S(-1, width bits), 3 -> lift.resize(width))
}
