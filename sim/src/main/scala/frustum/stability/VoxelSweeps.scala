package frustum.stability

import frustum.contract.voxel.{VoxelConfig, VoxelDomains, WorldSize}
import frustum.demos.voxel.Blocks
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.judge.{VoxelCounts, VoxelJudge}
import frustum.model.voxel.VoxelModel
import frustum.model.voxel.wide.VoxelRaySetup
import frustum.reference.voxel.IdealVoxelPicture
import frustum.scene.Hills

/** Views of a small world of hills, the model held against exact marching. */
object VoxelSweeps {
  private val base = VoxelConfig(size = WorldSize(32, 32, 16), width = 48, height = 36)
  private lazy val hills = Hills(base.size, 1)

  private def counts(c: VoxelConfig, view: VoxelView): VoxelCounts = {
    val model = new VoxelModel(c, Blocks.assets, hills)
    val camera = view.camera(c)
    val pixels = for (j <- 0 until c.height; i <- 0 until c.width) yield model.pixel(camera, i, j)
    new VoxelJudge(model).picture(camera, view, pixels)
  }
  private def raysWrong(c: VoxelConfig, view: VoxelView): Double = {
    val n = counts(c, view)
    (n.blocksWrong + n.facesWrong + n.texelsWrong).toDouble
  }
  private def view(x: Double, focal: Double = 36) = VoxelView(Vector3(x, 15.3, 12.4), 7, -20, focal)

  val all: Seq[Sweep] = Seq(
    Sweep(
      VoxelDomains.FocalLength,
      20,
      20000,
      1,
      Some(PeerDomain(None, "2.3 pixels off at 225: directions are whole numbers"))
    ) { focal =>
      val wide = base.copy(width = 320, height = 240, distance = 1)
      val eyes = for (yaw <- Seq(3, 48, 91, 200, 317); pitch <- Seq(-70, -5, 40))
        yield VoxelView(Vector3(15.5, 15.5, 15.5), yaw, pitch, focal)
      directionError(wide, eyes)
    },
    Sweep(VoxelDomains.EyeOutside, 0, 64, 0, whole = true)(d => raysWrong(base.copy(distance = 60), view(-d))),
    Sweep(VoxelDomains.ViewDistance, 1, 128, 0, whole = true)(d =>
      raysWrong(base.copy(distance = d.toInt), view(2.6))
    )
  )

  private def directionError(c: VoxelConfig, views: Seq[VoxelView]): Double = views.map { v =>
    val camera = v.camera(c)
    val ideal = IdealVoxelPicture.rays(v, c)
    (for (j <- 0 until c.height by 13; i <- 0 until c.width by 13) yield {
      val ray = VoxelRaySetup(camera.eye.axes, camera.direction(i, j), c)
      VoxelJudge.error(ideal, i, j, ray, c)
    }).max
  }.max
}
