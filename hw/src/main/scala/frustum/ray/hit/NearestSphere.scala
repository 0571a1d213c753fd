package frustum.ray.hit

import frustum.arithmetic.LockstepPipeline
import frustum.contract.ray.{RayScene, RayShade}
import frustum.device.Tech
import frustum.ray.shade.SphereShade
import frustum.ray.walk.RayWalkers
import spinal.core._
import spinal.lib._
import spinal.lib.misc.pipeline._

/** The nearest sphere that a pixel's ray hits, at node `start`, and its colour at the pipeline's last node.
  *
  * @param anyRay whether some pixel's ray may have no length
  */
class NearestSphere(
    scene: RayScene,
    walkers: RayWalkers,
    line: LockstepPipeline,
    start: Int,
    shade: Option[SphereShade],
    anyRay: Boolean
) extends Area {
  val HIT = Payload(Bool())
  val INDEX = Payload(UInt(4 bits))
  private val last = line.nodes.last
  private val indexBits = log2Up(scene.spheres.size)

  /** The one whose centre is nearest along the ray. */
  private val candidates = scene.spheres.indices.map { i =>
    val along = walkers(s"along$i")
    // Where it is 0 the discriminant is negative, unless the ray has no length.
    val before = if (anyRay) along > 0 else !along.msb
    (!walkers.negative(s"sphere$i") && before, along, U(i, 4 bits))
  }
  private val (hit, _, index) = candidates.reduceLeft { (l, r) =>
    val left = l._1 && (!r._1 || l._2 <= r._2)
    val width = scala.math.max(l._2.getWidth, r._2.getWidth)
    (l._1 || r._1, Mux(left, l._2.resize(width), r._2.resize(width)), Mux(left, l._3, r._3))
  }
  line(start)(HIT) := hit
  line(start)(INDEX) := index

  private def ofSphere(at: Node)(each: Int => Bits) =
    Vec(scene.spheres.indices.map(each)).read(at(INDEX).resize(indexBits))

  /** The sphere's colour at its level of light; the full colour without shade. */
  val color = shade match {
    case None    => ofSphere(last)(i => B(scene.spheres(i).color, 24 bits))
    case Some(s) =>
      def form(to: BitVector, name: String, age: Int): Unit = to.assignFromBits(
        ofSphere(line(start + age))(i => walkers(s"$name$i").resize(to.getWidth).asBits)
      )
      form(s.io.q, "sphere", 0)
      form(s.io.towards, "towards", s.towardsAge)
      form(s.io.lit, "lit", s.litAge)
      form(s.io.power, "power", s.powerAge)
      s.io.square := walkers("square").asUInt.resized
      val ramps = scene.spheres.indices.map(s.format.ramp)
      val at = line.nodes(line.nodes.size - 2)(INDEX).resize(indexBits) @@ s.io.level
      val size = RayShade.Levels << indexBits
      // A channel that no sphere has needs no memory.
      Seq(16, 8, 0).map { shift =>
        val words = ramps.flatten.map(_ >> shift & 255).padTo(size, 0)
        if (words.forall(_ == 0)) B(0, 8 bits)
        else Mem(Bits(8 bits), words.map(B(_, 8 bits))).readSync(at)
      }.reduce(_ ## _)
  }
}
