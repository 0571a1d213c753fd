package frustum.ray

import frustum.contract.video.VideoMode
import frustum.demos.pong.PongScene
import frustum.harness.FrustumSim
import frustum.ray.scene.RayConfig

/** Writes the ray caster of pong alone as Verilog, for a synthesis check: arguments folder, optionally "noLight",
  * "moving" for a camera that moves.
  */
object RayVerilog extends App {
  private val scene =
    if (args.contains("moving")) RandomScenes.moving(640, 480, 1, inside = false) else PongScene.room()
  private val chosen = if (args.contains("noLight")) scene.copy(light = None) else scene
  private val config = RayConfig(chosen, VideoMode.Vga640x480)
  FrustumSim.spinalConfig.copy(targetDirectory = args.head).generateVerilog {
    val r = RayPipeline(config)
    println(
      s"set-up ${r.setUpClocks} of ${config.mode.blankClocks} clocks, row load ${r.lineClocks} of " +
        s"${config.mode.hBlank}, digits ${config.setup.digitBits}, words ${config.program.size} x " +
        s"${config.program.wordWidth}, latency ${r.latency}"
    )
    for (f <- config.program.forms)
      println(s"${f.name} ${f.width} bits, ${f.registers} registers, ${f.loaded} loaded")
    r
  }
}
