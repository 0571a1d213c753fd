package frustum.ray

import frustum.arithmetic.LockstepPipeline
import frustum.contract.ray.Wall
import frustum.device.Tech
import frustum.ray.hit.{NearestSphere, ShadowStage, WallStage}
import frustum.ray.program.RaySetup
import frustum.ray.scene.{RayConfig, RayMotionBundle}
import frustum.ray.shade.SphereShade
import frustum.ray.surface.{SurfaceCells, SurfacePaint}
import frustum.ray.walk.RayWalkers
import spinal.core._
import spinal.lib._

/** Ray caster without a frame buffer: one pixel per cycle, `latency` cycles after `up`, no stalls.
  *
  * `latch`: at the start of the vertical blank, takes `motion`, which must stay for `takeClocks`. `line`: once before
  * each row, `lineClocks` or more before its first pixel, after the last pixel of the row before, and one row after the
  * last `line`. Everything a pixel needs is the sign of a polynomial with integer coefficients, see
  * [[frustum.contract.ray.RaySceneForms]]; cells are quotients found bit by bit.
  */
case class RayPipeline(config: RayConfig, tech: Tech = Tech.Generic) extends Component {
  import config.{mode, program, scene}
  val io = new Bundle {
    val motion = in(RayMotionBundle(scene))
    val latch, line = in Bool ()
    val up = slave(Flow(NoData())) // pixels, row by row
    val down = master(Flow(RayPixel()))
  }
  private val wallLatency = SurfaceCells.stages(scene) + 2

  /** Spheres' shades take longest; all else starts so late that it is ready with them. */
  val shade = config.shade.map(SphereShade(_, tech))
  val latency: Int = shade.fold(wallLatency)(s => (s.latency + 1).max(wallLatency))
  private val wallStart = latency - wallLatency
  private val levelAge = latency - 1
  private val shadeStart = levelAge - shade.fold(levelAge)(_.latency)

  val setup = RaySetup(config.setup)
  val takeClocks: Int = config.setup.takeClocks
  val setUpClocks: Int = config.setup.frameClocks
  val lineClocks: Int = config.setup.lineClocks + latency + 1
  require(
    setUpClocks <= config.frameLimit,
    s"set-up of $setUpClocks cycles in a blank of ${mode.blankClocks}"
  )
  require(lineClocks <= mode.hBlank, s"row load of $lineClocks cycles in a blank of ${mode.hBlank}")
  require(
    lineClocks + config.setup.rowClocks <= mode.hTotal,
    s"row load and steps of ${lineClocks + config.setup.rowClocks} cycles in a row of ${mode.hTotal}"
  )
  require(latency < mode.width, s"latency $latency in rows of ${mode.width}")

  setup.io.latch := io.latch
  for ((to, i) <- setup.io.inputs.zip(program.inputs)) to := io.motion(i)

  val line = new LockstepPipeline(latency)
  line(0).valid := io.up.valid
  line.nodes.last.ready := True

  /** The last walker must have done the row before. */
  val waiting = RegInit(False)
  setup.io.line := waiting && !line.nodes.last.isValid
  when(setup.io.line)(waiting := False)
  when(io.line)(waiting := True)

  /** Node at which a form is read. */
  private def node(form: String): Int = {
    def isA(names: String*) = names.exists(n => form.startsWith(n))
    if (isA("sphere", "along")) shadeStart
    else shade.filter(_ => isA("towards", "lit", "square")).fold(wallStart) { s =>
      shadeStart + (if (isA("towards")) s.towardsAge else if (isA("lit")) s.litAge else s.squareAge)
    }
  }
  val walkers = new RayWalkers(config, setup.io.load, line, node)
  val walls = new WallStage(scene, walkers, line, wallStart)
  val shadow = new ShadowStage(scene, walkers, line, walls, wallStart)
  val cells = new SurfaceCells(scene, walkers, line, walls, wallStart)
  val spheres = scene.spheres.nonEmpty generate
    new NearestSphere(scene, walkers, line, shadeStart, shade, config.anyRay)
  val paint = new SurfacePaint(scene, line, walls, cells)

  /** Sphere before wall or quad before background. */
  private val last = line.nodes.last
  private val full = paint.color
  private val surface = last(walls.SURFACE)
  val color = Mux(
    surface.orR,
    Mux(last(shadow.SHADOW), (full |>> 1) & B(0x7f7f7f, 24 bits), full),
    B(scene.background, 24 bits)
  )
  val objectId = UInt(4 bits)
  objectId := Mux(surface.orR, U(1, 4 bits), U(0, 4 bits))
  for (i <- scene.quads.indices) when(surface(Wall.all.size + i))(objectId := 2 + i)
  if (scene.spheres.nonEmpty) when(last(spheres.HIT)) {
    color := spheres.color
    objectId := last(spheres.INDEX) + (2 + scene.quads.size)
  }
  io.down.valid := last.isValid
  io.down.rgb.r := color(23 downto 16).asUInt
  io.down.rgb.g := color(15 downto 8).asUInt
  io.down.rgb.b := color(7 downto 0).asUInt
  io.down.objectId := objectId
  line.build()
}
