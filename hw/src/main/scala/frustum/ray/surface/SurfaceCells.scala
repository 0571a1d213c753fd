package frustum.ray.surface

import frustum.arithmetic.LockstepPipeline
import frustum.contract.ray.RayScene
import frustum.ray.hit.WallStage
import frustum.ray.walk.RayWalkers
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Number of the cell that is hit, along both coordinates of its surface: floor(coordinate / (n 2^cellBits)) by
  * comparing and subtracting, a bit a node from `start` + 2 on. A floor's lower bits go first, so that all surfaces
  * share the divider: floor(floor(x / 2^cellBits) / n).
  */
class SurfaceCells(scene: RayScene, walkers: RayWalkers, line: LockstepPipeline, walls: WallStage, start: Int)
    extends Area {
  private val surfaces = Surface.all(scene)
  private val stages = SurfaceCells.stages(scene)
  private val select = line(start + 1)

  /** Lowest bits of the number along coordinate 0 and 1, at node `start` + 1 + stages. */
  val bits: Seq[Bits] = (0 to 1).map { j =>
    val looking = surfaces.filter(_.bits(j) > 0)
    val keep = looking.map(_.bits(j)).reduceOption(_ max _).getOrElse(0)
    if (keep == 0) B(0, 0 bits)
    else {
      def shifted(s: Surface) = walkers.width(s.forms(j)) - s.paint.cellBits
      val width = looking.map(shifted).max.max(1)
      val offsets =
        looking.map(s => walkers.kept(s.forms(j))(v => (v >> s.paint.cellBits).resize(width).asUInt))
      val head = select.insert(MuxOH.or(
        looking.map(s => select(walls.SURFACE)(surfaces.indexOf(s))).asBits(),
        offsets.map(_(select))
      ))
      val quotient = (0 until stages).foldLeft((head, width, Seq[Payload[Bool]]())) {
        case ((rest, width, found), k) =>
          val node = line(start + 2 + k)
          val i = stages - 1 - k
          val wide = scala.math.max(width, walls.widthN + i) + 1
          val difference = node(rest).resize(wide) - (node(walls.N) << i).resize(wide)
          // What is left is less than n 2^i.
          val left = scala.math.min(width, walls.widthN + i)
          val less = Mux(difference.msb, node(rest).resize(wide), difference).resize(left)
          (node.insert(less), left, found :+ node.insert(!difference.msb))
      }._3
      quotient.takeRight(keep).reverse.map(b => line(start + 1 + stages)(b)).asBits()
    }
  }
}

object SurfaceCells {

  /** Nodes of the divider. */
  def stages(scene: RayScene): Int = {
    val all = for (s <- Surface.all(scene); j <- 0 to 1 if s.bits(j) > 0) yield s.quotient(j)
    if (all.isEmpty) 0 else all.max.max(1)
  }
}
