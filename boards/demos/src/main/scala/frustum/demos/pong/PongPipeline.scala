package frustum.demos.pong

import frustum.arithmetic.MemoryDelay
import frustum.contract.ray.{RayMotion, RayScene}
import frustum.contract.video.{ColorFormat, Font, TextField, VideoMode}
import frustum.demos.pad.Buttons
import frustum.device.Tech
import frustum.ray.RayPipeline
import frustum.ray.scene.RayConfig
import frustum.video.{OrderedDither, PixelScanner, TextOverlay, VideoBus}
import spinal.core._
import spinal.lib._

/** What pong draws, and where to.
  *
  * @param scene sphere 0 is the puck and quad 0 the paddle, as [[PongScene.room]] has them; others do not move
  */
case class PongPipelineConfig(
    mode: VideoMode = VideoMode.Vga640x480,
    format: ColorFormat = ColorFormat.Rgb444,
    scene: RayScene = PongScene.room()
) {
  require(
    scene.spheres.nonEmpty && scene.quads.nonEmpty,
    s"pong is a puck and a paddle: the scene has ${scene.spheres.size} spheres, ${scene.quads.size} quads"
  )
  private val stillSpheres = scene.spheres.tail
  private val stillQuads = scene.quads.tail
  for (((low, high), i) <- stillSpheres.map(s => (s.low, s.high)).zipWithIndex)
    require(
      low == high,
      s"sphere ${i + 1} moves from $low to $high: the game moves the puck, sphere 0, alone; give a centre"
    )
  for (((low, high), i) <- stillQuads.map(q => (q.low, q.high)).zipWithIndex)
    require(
      low == high,
      s"quad ${i + 1} moves from $low to $high: the game moves the paddle, quad 0, alone; give a centre"
    )

  /** Where everything is when puck and paddle are where the game has them. */
  def motion(game: RayMotion): RayMotion =
    game.copy(spheres = game.spheres ++ stillSpheres.map(_.low), quads = game.quads ++ stillQuads.map(_.low))

  require(
    scene.camera.fixed,
    s"pong's camera is constant: the scene's goes from ${scene.camera.low} to ${scene.camera.high}"
  )
  require(
    mode.width >= 16 * Font.Cell,
    s"pictures of ${mode.width} pixels, at least ${16 * Font.Cell} for the text"
  )

  /** Four letters take at most half of the width. */
  private val scale = log2Up(mode.width / (8 * Font.Cell) + 1) - 1
  val score: TextField = TextField.centred(mode.width, 0, 2, scale - 1)
  val message: TextField = TextField.centred(mode.width, mode.height / 2 / (Font.Cell << scale), 4, scale)
}

/** 3-D pong to a monitor, one pixel per cycle: buttons, game, ray caster, score, dither. What is drawn changes in the
  * vertical blank alone; `video` is registered and comes `latencyClocks` after the scanner's position.
  *
  * @param fast whether there are more registers, in the ray caster and before the dither, for a higher clock frequency
  */
case class PongPipeline(config: PongPipelineConfig, tech: Tech = Tech.Generic, fast: Boolean = false)
    extends Component {
  import config.{format, mode, scene}
  val io = new Bundle {
    val buttons = in(PongButtons()) // high = pressed, asynchronous, bouncing
    val video = master(VideoBus(format))
  }
  val scanner = PixelScanner(mode)

  val buttons = Buttons(4)
  buttons.io.pins := io.buttons.asBits
  buttons.io.sample := scanner.io.frameEnd

  val frames = Counter(PongRules.FramesPerTick, scanner.io.frameEnd)
  val game = PongGame()
  game.io.tick := RegNext(frames.willOverflow) init False
  game.io.buttons.assignFromBits(buttons.io.held)

  val ray = RayPipeline(RayConfig(scene, mode, fast), tech)
  private val ticked = PongGame.TickClocks + 2 // cycles until a tick that `frameEnd` starts is done
  ray.io.latch := Delay(scanner.io.frameEnd, ticked, init = False)
  ray.io.line := scanner.io.line
  ray.io.up.valid := scanner.io.active
  for (a <- 0 to 2) {
    ray.io.motion.spheres(0)(a) := game.io.puck(a)
    for (i <- scene.spheres.indices.tail) ray.io.motion.spheres(i)(a) := S(scene.spheres(i).low(a), 12 bits)
    for (i <- scene.quads.indices.tail) ray.io.motion.quads(i)(a) := S(scene.quads(i).low(a), 12 bits)
  }
  ray.io.motion.quads(0).x := game.io.paddleX
  ray.io.motion.quads(0).y := game.io.paddleY
  ray.io.motion.quads(0).z := scene.quads(0).low.z

  val overlay =
    TextOverlay(Seq(config.score, config.message), log2Up(scala.math.max(mode.hTotal, mode.vTotal)))
  private def letters(word: String) = Vec(word.map(c => U(Font.code(c), Font.CodeBits bits)))
  private def digit(d: UInt) = U(Font.code('0'), Font.CodeBits bits) | d.resized
  overlay.io.x := scanner.io.x.resized
  overlay.io.y := scanner.io.y.resized
  overlay.io.text(0) := Vec(digit(game.io.tens), digit(game.io.ones))
  overlay.io.text(1) := Mux(game.io.won, letters("WIN!"), letters("LOSE"))
  overlay.io.shown := (game.io.won || game.io.lost) ## True

  private val beforeDither = if (fast) 1 else 0
  private val colourLatency = ray.latency + beforeDither

  /** The ray caster has the longest latency; all else is delayed to it, and a last register is the pins'. */
  val latencyClocks: Int = colourLatency + 1
  require(latencyClocks < PixelScanner.Tail, s"latency $latencyClocks, at most ${PixelScanner.Tail - 1}")
  require(
    ray.latency >= TextOverlay.Latency,
    s"the ray caster's ${ray.latency} cycles are fewer than the text's"
  )

  /** Sync pulses, 0 while idle, and text, all as late as the text by itself. */
  private def early(pulse: Bool, positive: Boolean) =
    Delay(pulse ^ Bool(!positive), TextOverlay.Latency, init = False)
  private val late = MemoryDelay(
    overlay.io.cell ## overlay.io.dot ## early(scanner.io.hSync, mode.hPositive) ## early(
      scanner.io.vSync,
      mode.vPositive
    ),
    ray.latency - TextOverlay.Latency
  )
  // After a reset the memory still holds what was in flight: no pulse of it reaches the pins.
  private val settled = RegInit(False) setWhen scanner.io.frameEnd
  private val (cell, dot) = (late(3), late(2))
  private def toDither(pulse: Bool) = Delay(pulse, beforeDither, init = False)
  private val visible = toDither(ray.io.down.valid)
  private val (hPulse, vPulse) = (toDither(late(1) && settled), toDither(late(0) && settled))

  val dither = OrderedDither(format)
  // The scanner is ahead by the latency, into the blank at most: its row is the pixel's.
  require(colourLatency < mode.hBlank, s"latency $colourLatency in a blank of ${mode.hBlank}")
  dither.io.x := scanner.io.x(1 downto 0) - (colourLatency & 3)
  dither.io.y := scanner.io.y(1 downto 0)
  private def written(c: UInt) = Delay(Mux(dot, U(255, 8 bits), Mux(cell, c |>> 1, c)), beforeDither)
  dither.io.rgb.r := written(ray.io.down.rgb.r)
  dither.io.rgb.g := written(ray.io.down.rgb.g)
  dither.io.rgb.b := written(ray.io.down.rgb.b)

  private def lateSync(pulse: Bool, positive: Boolean) = RegNext(pulse ^ Bool(!positive)) init Bool(!positive)
  io.video.active := RegNext(visible) init False
  io.video.hSync := lateSync(hPulse, mode.hPositive)
  io.video.vSync := lateSync(vPulse, mode.vPositive)
  private def pin(c: UInt) = RegNext(Mux(visible, c, U(0).resized))
  io.video.red := pin(dither.io.red)
  io.video.green := pin(dither.io.green)
  io.video.blue := pin(dither.io.blue)
}
