package frustum.charts

import frustum.contract.voxel.VoxelConfig
import frustum.device.Tech
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.judge.VoxelJudge
import frustum.model.voxel.wide.VoxelRaySetup
import frustum.reference.voxel.IdealVoxelPicture
import frustum.synthesis.UnitCosts
import scala.util.Random

/** Bits of the slopes of the voxel world's rays: how far a ray passes by its pixel. */
object DirectionFamily extends ChartFamily {
  val name = "directions"

  private val bits = 12 to 15
  private val views = {
    val random = new Random(1)
    Seq.fill(24)(VoxelView(
      Vector3(32, 32, 16),
      random.nextDouble() * 360,
      random.nextDouble() * 180 - 90,
      225
    ))
  }

  /** Greatest error in pixels. */
  def error(slopeBits: Int): Double = {
    val c = VoxelConfig(slopeBits = slopeBits)
    (for (view <- views) yield {
      val camera = view.camera(c)
      val ideal = IdealVoxelPicture.rays(view, c)
      (for (j <- 0 until c.height by 9; i <- 0 until c.width by 9) yield {
        val ray = VoxelRaySetup(camera.eye.axes, camera.direction(i, j), c)
        VoxelJudge.error(ideal, i, j, ray, c)
      }).max
    }).max
  }

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val points = for (n <- bits) yield {
      val unit =
        costs.map(_.timed(s"ray set-up with slopes of $n bits")(frustum.voxel.wide.VoxelRaySetup(
          VoxelConfig(slopeBits = n),
          Tech.Ice40
        )))
      ChartPoint("reciprocal by table and line", s"$n bits", unit.fold(n.toDouble)(_.cells), error(n), unit)
    }
    Seq(Chart(
      "directions",
      "Directions of the voxel world's rays, 320 x 240, focal length 225",
      if (costs.isDefined) "LUT and flip-flops of the ray set-up, iCE40" else "bits of a slope",
      "greatest error, pixels",
      points,
      points.find(_.setting == s"${VoxelConfig().slopeBits} bits"),
      Some(ChartPoint("whole numbers (the original)", "", points.head.cost, 2.3)),
      1e-4,
      "The original's directions are whole numbers, 2.3 pixels off at worst (its cost is not known: it is drawn at " +
        "our least)."
    ))
  }
}
