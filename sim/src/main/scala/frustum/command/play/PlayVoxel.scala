package frustum.command.play

import frustum.command.voxel.{VoxelScene, VoxelScenes}
import frustum.contract.arithmetic.IntVector
import frustum.contract.video.Crosshair
import frustum.contract.voxel.{SeenFace, VoxelCamera, VoxelConfig}
import frustum.demos.voxel.{CameraProgram, VoxelRules}
import frustum.driver.voxel.VoxelView
import frustum.engine.EngineSim
import frustum.engine.voxel.{VoxelEngines, VoxelSession}
import frustum.model.demos.voxel.{PlayerCamera, VoxelPlayer}
import frustum.model.voxel.VoxelModel
import frustum.play.{LiveScreen, VoxelKeys}

/** `play voxel`: walk, look, place and destroy in a world of blocks. Player and camera are the model's, which the
  * hardware's equal bit for bit; the picture is the simulated pipeline's, or the model's.
  */
object PlayVoxel {
  val Engines: Seq[String] = Seq("hardware", "model")
  private val Size = (160, 120)

  def apply(o: PlayOptions): Int = {
    val hardware = o.engineOf(VoxelEngines, Engines).kind.simulated
    val scene = VoxelScenes(o.voxel.copy(seed = o.seed, size = o.size.getOrElse(Size)))
    LiveScreen.require()
    println(VoxelKeys.help)
    if (hardware)
      EngineSim.run(VoxelSession.compile(scene.config, scene.assets), None, o.seed) { dut =>
        val session = new VoxelSession(dut)
        play(scene, o.fly, o.frames, Some(session))
      }
    else play(scene, o.fly, o.frames, None)
  }

  private def play(
      scene: VoxelScene,
      fly: Boolean,
      frames: Option[Int],
      session: Option[VoxelSession]
  ): Int = {
    val VoxelScene(config, assets, _, views) = scene
    val rules = VoxelRules(config.size, assets.table.blocks.length, gravity = !fly)
    val scale = (640 / config.width).max(1)
    val screen = LiveScreen("Frustum: world of blocks", config.width, config.height, scale)
    try {
      views.head.camera(config) // refuses what the hardware does not take
      val program = CameraProgram(config.width, config.height, views.head.focal)
      var model = new VoxelModel(config, assets, scene.world)
      var player = start(views.head)
      var pointed = Option.empty[SeenFace]
      session.foreach(_.load(model.words))
      val started = System.nanoTime
      var shown = 0
      while (screen.isOpen && frames.forall(shown < _)) {
        val (moved, edit) =
          player.frame(VoxelKeys(screen.keys()), rules, assets.table, pointed, model.world(_, _, _))
        player = moved
        for (e <- edit) {
          val old = model.words
          model = new VoxelModel(config, assets, model.world.updated(e.x, e.y, e.z, e.id))
          session.foreach(_.load(model.words, old))
        }
        val camera = PlayerCamera(player, config, program)
        pointed = model.pointedAt(camera, VoxelConfig.Reach)
        screen.show(
          crosshair(draw(model, camera, session), config),
          state(player, assets.table(player.item).name)
        )
        shown += 1
      }
      println(PlayCommand.summaryOf(shown, started, s"${player.refused} edits refused"))
      0
    } finally screen.close()
  }

  private def draw(model: VoxelModel, camera: VoxelCamera, session: Option[VoxelSession]): Array[Int] =
    session match {
      case Some(s) => s.frame(camera, highlight = true).picture
      case None    =>
        val c = model.config
        val chosen = model.pointedAt(camera, VoxelConfig.Reach)
        Array.tabulate(c.pixels)(n => model.pixel(camera, n % c.width, n / c.width, chosen).color)
    }

  private def start(v: VoxelView): VoxelPlayer = {
    def fixed(x: Double) = (256 * x).round.toInt
    VoxelPlayer(
      IntVector(fixed(v.eye.x), fixed(v.eye.y), (fixed(v.eye.z) - VoxelRules.EyeHeight).max(0)),
      yaw = (v.yaw / 360 * VoxelRules.Turn).round.toInt,
      pitch =
        (v.pitch / 360 * VoxelRules.Turn).round.toInt.max(-VoxelRules.MostPitch).min(VoxelRules.MostPitch)
    )
  }

  private def crosshair(picture: Array[Int], c: VoxelConfig): Array[Int] = {
    val cross = Crosshair(c.width, c.height)
    for (n <- picture.indices if cross.covers(n % c.width, n / c.width)) picture(n) ^= 0xffffff
    picture
  }

  private def state(p: VoxelPlayer, item: String): String =
    f"$item, at ${p.eye.x / 256.0}%.1f ${p.eye.y / 256.0}%.1f ${p.eye.z / 256.0}%.1f"
}
