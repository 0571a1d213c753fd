package frustum.engine.voxel

import frustum.contract.InputError
import frustum.driver.voxel.VoxelView
import frustum.engine.EngineSim
import frustum.voxel.CompactVoxelPipeline

/** The compact pipeline in simulation: draws each view with a sink that is always ready, and again at the pace of
  * icebreaker-voxel's display. Pictures have the colours of RGB565.
  */
final class CompactVoxelEngine(setting: VoxelSetting) extends VoxelEngine {
  import setting.{assets, config, highlight}
  CompactVoxelPipeline.fault(config).foreach(fault => throw InputError(s"--engine compact: $fault"))

  override def expected(model: Array[Int]): Seq[Array[Int]] = Seq.fill(2)(model.map(CompactVoxelSession.shown))

  def draw(views: Iterator[VoxelView])(each: RenderedView => Unit): Unit =
    EngineSim.run(CompactVoxelSession.compile(config, assets), None, setting.seed) { dut =>
      val session = new CompactVoxelSession(dut)
      session.load(setting.model.words)
      for (view <- views) {
        val camera = view.camera(config)
        val fast = session.frame(camera, highlight)
        val slow = session.frame(camera, highlight, pace = CompactVoxelSession.DisplayPace)
        each(RenderedView(Seq(fast.picture, slow.picture), Some(fast.clocks), Some(slow.clocks)))
      }
    }
}
