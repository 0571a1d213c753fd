package frustum.command

import frustum.engine.{EngineSim, VoxelSession}
import frustum.game.VoxelKeys
import frustum.host.VoxelView
import frustum.live.LiveScreen
import frustum.model.game.{VoxelButtons, VoxelPlayer, VoxelRules}
import frustum.model.pipelines.VoxelModel
import frustum.spec.{IntVector, VoxelCamera, VoxelConfig}
import java.util.Locale
import org.joml.Vector3d

/** `play voxel`: walk, look, place and destroy in a world of blocks. The player is the workbench's; the picture is the simulated
  * pipeline's, or the model's.
  */
object PlayVoxel {

  /** @param frames ends after so many; None: when the window is closed */
  def apply(scene: VoxelScene, hardware: Boolean, fly: Boolean, frames: Option[Int], seed: Long): Int = {
    LiveScreen.require()
    println(VoxelKeys.help)
    if (hardware)
      EngineSim.run(VoxelSession.compile(scene.config, scene.assets), None, seed) { dut =>
        val session = new VoxelSession(dut)
        play(scene, fly, frames, Some(session))
      }
    else play(scene, fly, frames, None)
  }

  private def play(
      scene: VoxelScene,
      fly: Boolean,
      frames: Option[Int],
      session: Option[VoxelSession]
  ): Int = {
    val VoxelScene(config, assets, _, views) = scene
    val rules  = VoxelRules(config.size, assets.table.blocks.length, gravity = !fly)
    val scale  = (640 / config.width).max(1)
    val screen = LiveScreen("Frustum: world of blocks", config.width, config.height, scale)
    try {
      var model  = new VoxelModel(config, assets, scene.world)
      var player = start(views.head)
      session.foreach(_.load(model.words))
      val started = System.nanoTime
      var shown   = 0
      while (screen.isOpen && frames.forall(shown < _)) {
        val buttons = VoxelKeys(screen.keys())
        val before  = player.held
        player = player.tick(buttons, rules, VoxelPlayer.solid(assets.table, model.world(_, _, _)))
        val camera          = view(player, views.head.focal).camera(config)
        val (counted, edit) = player.edit(buttons, before, model.pointedAt(camera, VoxelConfig.Reach), rules)
        player = counted
        for (e <- edit) {
          val old = model.words
          model = new VoxelModel(config, assets, model.world.updated(e.x, e.y, e.z, e.id))
          session.foreach(_.load(model.words, old))
        }
        screen.show(
          crosshair(draw(model, camera, session), config),
          state(player, assets.table(player.item).name)
        )
        shown += 1
      }
      val rate = shown * 1e9 / (System.nanoTime - started)
      println(
        s"$shown frames, ${"%.1f".formatLocal(Locale.ROOT, rate)} a second, ${player.refused} edits refused"
      )
      0
    } finally screen.close()
  }

  private def draw(model: VoxelModel, camera: VoxelCamera, session: Option[VoxelSession]): Array[Int] =
    session match {
      case Some(s) => s.frame(camera, highlight = true).picture
      case None    =>
        val c      = model.config
        val chosen = model.pointedAt(camera, VoxelConfig.Reach)
        Array.tabulate(c.pixels)(n => model.pixel(camera, n % c.width, n / c.width, chosen).color)
    }

  private def start(v: VoxelView): VoxelPlayer = {
    def fixed(x: Double) = (256 * x).round.toInt
    VoxelPlayer(
      IntVector(fixed(v.eye.x), fixed(v.eye.y), (fixed(v.eye.z) - VoxelPlayer.EyeHeight).max(0)),
      yaw = (v.yaw / 360 * VoxelPlayer.Turn).round.toInt,
      pitch =
        (v.pitch / 360 * VoxelPlayer.Turn).round.toInt.max(-VoxelPlayer.MostPitch).min(VoxelPlayer.MostPitch)
    )
  }

  private def view(p: VoxelPlayer, focal: Double): VoxelView = VoxelView(
    new Vector3d(p.eye.x, p.eye.y, p.eye.z).div(256),
    360.0 * p.yaw / VoxelPlayer.Turn,
    360.0 * p.pitch / VoxelPlayer.Turn,
    focal
  )

  /** 13 pixels in the middle, inverted: the window's, not the hardware's. */
  private def crosshair(picture: Array[Int], c: VoxelConfig): Array[Int] = {
    for (k <- -3 to 3; (dx, dy) <- Set((k, 0), (0, k))) {
      val at = (c.height / 2 + dy) * c.width + c.width / 2 + dx
      picture(at) ^= 0xffffff
    }
    picture
  }

  private def state(p: VoxelPlayer, item: String): String =
    f"$item, at ${p.eye.x / 256.0}%.1f ${p.eye.y / 256.0}%.1f ${p.eye.z / 256.0}%.1f"
}
