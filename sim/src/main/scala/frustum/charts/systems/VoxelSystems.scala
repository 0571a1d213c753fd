package frustum.charts.systems

import frustum.boards.{BoardTop, Tops}
import frustum.boards.arty.ArtyTops
import frustum.charts.{DirectionFamily, LeapFamily}
import frustum.contract.voxel.{LeapField, VoxelConfig}

/** Worlds of blocks on the Arty: rays a second against the world's bits of memory, and against the error of the rays'
  * directions. The ring of the wide pipeline takes a step a cycle, so that rays a second are the clock over the steps
  * of a ray, by the model.
  */
final class VoxelSystems(tops: BoardTop => (Option[Placed], String)) {
  private val shipped = ArtyTops.voxelConfig.voxel
  private val top = Tops.find("arty-voxel").get
  private lazy val placed = tops(top)._1.flatMap(_.clockMHz)
  private val blocks = shipped.size.axes.product

  private def point(
      group: String,
      setting: String,
      c: VoxelConfig,
      memory: Boolean,
      direction: Boolean
  ): SystemPoint = {
    val clock = if (c.copy(width = shipped.width, height = shipped.height) == shipped) placed else None
    val mhz = clock.getOrElse(top.targetMHz.toDouble)
    val steps = LeapFamily.steps(c)
    SystemPoint(
      group,
      setting,
      mhz / steps,
      mhz,
      clock.isDefined,
      built = true,
      None,
      Seq(
        Option.when(memory)(blocks.toDouble * c.leaps.wordBits / 1024),
        Option.when(direction)(DirectionFamily.error(c.slopeBits))
      ),
      Seq("stepsPerRay" -> steps)
    )
  }

  def chart: SystemChart = {
    def leap(group: String, f: LeapField) =
      point(
        group,
        if (f.most == 1) "none" else s"up to ${f.most}",
        shipped.copy(leaps = f),
        memory = true,
        direction = f == shipped.leaps
      )
    val groups = for {
      (name, mask) <- Seq(
        "one leap for all directions" -> 0,
        "leaps up and down" -> 4,
        "leaps up or down and +x or -x" -> 5,
        "leaps for each octant" -> 7
      )
      bits <- 1 to 4
      field <- Option.when(bits << Integer.bitCount(mask) <= 24)(LeapField(mask, bits))
    } yield leap(name, field)
    val slopes = Seq(12, 13, 14).map(n =>
      point("bits of a ray's slopes", s"$n", shipped.copy(slopeBits = n), memory = false, direction = true)
    )
    SystemChart(
      "systems-voxels",
      "World of blocks: rays a second against memory, and against the rays' directions",
      "million rays a second: a step a cycle, over the steps of a ray",
      Seq("memory of a world of 64 x 64 x 32, kbit", "greatest error of a direction, pixels"),
      (leap("a block a step, as the compared systems do", LeapField.Plain) +: groups) ++ slopes,
      Nil,
      s"Views of a walker over hills of three seeds. The Arty's has leaps up to ${shipped.leaps.most} in words of " +
        s"${shipped.leaps.wordBits} bits and slopes of ${shipped.slopeBits} bits."
    )
  }
}
