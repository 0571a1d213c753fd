package frustum.ray.hit

import frustum.arithmetic.LockstepPipeline
import frustum.contract.ray.{RayScene, Wall}
import frustum.ray.walk.RayWalkers
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** Which wall a pixel's ray hits and which quad is there, from the signs of the forms at node `start`. A node later
  * there are `WALL`, and `SURFACE`, which has the back wall where no quad is, then the quads (both one hot), and the
  * wall's `N`.
  */
class WallStage(scene: RayScene, walkers: RayWalkers, line: LockstepPipeline, start: Int) extends Area {
  val WALL = Payload(Bits(Wall.all.size bits))
  val SURFACE = Payload(Bits(Wall.all.size + scene.quads.size bits))
  val widthN = Wall.all.map(w => walkers.width(s"direction${w.axis}")).max
  val N = Payload(UInt(widthN bits))
  private val HITS = Payload(Bits(Wall.all.size bits))
  private val SIDES = Payload(Bits(scene.quads.size bits))
  private val (test, select) = (line(start), line(start + 1))

  /** Of walls that meet in an edge, whether the ray meets p no later than q: k_q n_p >= k_p n_q, which is also the
    * border of p across q's axis, and with p and q exchanged.
    */
  private val before = Wall.pairs.map { case (p, q) =>
    val late = walkers(s"across${q.index}_${p.axis}")
    val sign =
      if (q.sign < 0) !walkers.negative(s"across${p.index}_${q.axis}")
      else if (p.sign < 0) late.msb || late === 0
      else !walkers.negative(s"before${p.index}_${q.index}")
    (p.index, q.index) -> sign
  }.toMap
  test(HITS) := Wall.all.map { w =>
    val backward = walkers.negative(s"direction${w.axis}")
    val others = Wall.all.filter(_.axis != w.axis).map { q =>
      if (w.index < q.index) before(w.index, q.index) else !before(q.index, w.index)
    }
    // The room has no wall at its front: its border there is the wall's own.
    val front = w.across.filter(u => !Wall.all.exists(q => q.axis == u && q.sign < 0))
    val open = front.map(u => !walkers.negative(s"across${w.index}_$u"))
    (others ++ open).reduce(_ && _) && (if (w.sign > 0) !backward else backward)
  }.asBits()
  test(SIDES) := scene.quads.indices.map { i =>
    Seq("quad", "quadEnd").flatMap(end => (0 to 1).map(u => !walkers.negative(s"$end${i}_$u"))).reduce(_ && _)
  }.asBits()

  private val normals = (0 to 2).map(a => walkers.kept(s"direction$a")(d => d))
  private val first = OHMasking.first(select(HITS))
  select(WALL) := first
  select(SURFACE) := (if (scene.quads.isEmpty) first else surface)
  private def surface = {
    val quad = Mux(first.msb, OHMasking.first(select(SIDES)), B(0, scene.quads.size bits))
    quad ## (first.msb && !quad.orR) ## first.dropHigh(1)
  }
  select(N) := MuxOH.or(
    first,
    Wall.all.map { w =>
      val d = normals(w.axis)(select)
      (if (w.sign > 0) d else -d).asUInt.resize(widthN)
    }
  )
}
