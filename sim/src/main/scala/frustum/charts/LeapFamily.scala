package frustum.charts

import frustum.contract.voxel.{LeapField, VoxelConfig}
import frustum.demos.voxel.Blocks
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.model.voxel.march.Marcher
import frustum.model.voxel.wide.VoxelRaySetup
import frustum.model.voxel.world.LeapWords
import frustum.scene.Hills
import frustum.synthesis.UnitCosts

/** Leaps of the voxel world: bits of a memory word against steps of a ray, which are clocks, over hills of three
  * seeds.
  */
object LeapFamily extends ChartFamily {
  val name = "leaps"

  private val groups =
    Seq("one for all directions" -> 0, "up and down" -> 4, "up and down, +x and -x" -> 5, "each octant" -> 7)
  private val base = VoxelConfig(width = 64, height = 48)

  private lazy val worlds = (1 to 3).map(Hills(base.size, _))

  /** Mean steps a ray. */
  def steps(field: LeapField): Double = steps(base.copy(leaps = field))

  /** The same of any configuration of a world of this size, on pictures of this family's size. */
  def steps(config: VoxelConfig): Double = {
    val c = config.copy(width = base.width, height = base.height)
    require(c.size == base.size, s"a world of ${c.size}: the hills are of ${base.size}")
    val field = c.leaps
    val counts = for {
      world <- worlds
      march = new Marcher(c, Blocks.table, LeapWords(world, field))
      yaw <- 0 until 360 by 45
      x = 20 + yaw % 24
      camera = VoxelView(Vector3(x + 0.4, 32.6, world.surface(x, 32) + 2.6), yaw + 10, -8, 45).camera(c)
      j <- 0 until c.height
      i <- 0 until c.width
    } yield march.march(VoxelRaySetup(camera.eye.axes, camera.direction(i, j), c))(_ => ())
    counts.map(_.toLong).sum.toDouble / counts.length
  }

  def charts(costs: Option[UnitCosts]): Seq[Chart] = {
    val plain = ChartPoint("a block a step", "0 bits", LeapField.Plain.wordBits, steps(LeapField.Plain))
    val points =
      for ((method, mask) <- groups; bits <- 1 to 4 if bits << Integer.bitCount(mask) <= 24) yield {
        val field = LeapField(mask, bits)
        field -> ChartPoint(method, s"to ${field.most}", field.wordBits, steps(field))
      }
    Seq(Chart(
      "leaps",
      "Leaps over air, hills of three seeds, a walker's views",
      "bits of a word of the world's memory",
      "steps (clocks) a ray",
      plain +: points.map(_._2),
      points.collectFirst { case (field, p) if field == VoxelConfig().leaps => p },
      Some(plain),
      1,
      "A word holds a block's id or the distances of air."
    ))
  }
}
