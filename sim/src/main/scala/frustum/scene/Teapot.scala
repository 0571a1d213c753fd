package frustum.scene

import frustum.driver.linear.Vector3
import frustum.driver.scene.{MeshVertex, Triangle}

/** The Utah teapot: the 32 bicubic patches Martin Newell published in 1975 (with the bottom added in 1987),
  * here put together from what they are made of. Rim, body, lid and bottom are surfaces of revolution, each
  * quarter turn a patch; handle and spout are swept sections, each half a patch. z is up, the spout points
  * along +x.
  */
object Teapot {

  /** A patch and the steps it is cut into at tessellation 6. */
  final case class Part(name: String, patch: BezierPatch, stepsU: Int, stepsV: Int)

  /** A ring of control points: radius, height, and how far the inner two of a quarter's four stand off the
    * axes.
    */
  private final case class Ring(radius: Double, height: Double, reach: Double)

  /** The published points approximate a quarter of a circle with 0.56 of the radius (the best cubic has
    * 0.5523).
    */
  private def ring(radius: Double, height: Double): Ring = Ring(radius, height, 0.56 * radius)

  private val rim = Seq(ring(1.4, 2.4), ring(1.3375, 2.53125), ring(1.4375, 2.53125), ring(1.5, 2.4))
  private val shoulder = Seq(ring(1.5, 2.4), ring(1.75, 1.875), ring(2, 1.35), ring(2, 0.9))
  private val belly = Seq(ring(2, 0.9), ring(2, 0.45), ring(1.5, 0.225), ring(1.5, 0.15))
  private val knob = Seq(ring(0, 3.15), Ring(0.8, 3.15, 0.45), ring(0, 2.85), ring(0.2, 2.7))
  private val lid = Seq(ring(0.2, 2.7), ring(0.4, 2.55), ring(1.3, 2.55), ring(1.3, 2.4))
  private val bottom = Seq(ring(1.5, 0.15), ring(1.5, 0.075), ring(1.425, 0), ring(0, 0))

  /** A section of handle or spout: its two ends in the plane of symmetry, and half its width. */
  private final case class Section(x0: Double, z0: Double, x1: Double, z1: Double, halfWidth: Double)

  private val handle = Seq(
    Section(-1.6, 2.025, -1.5, 2.25, 0.3),
    Section(-2.3, 2.025, -2.5, 2.25, 0.3),
    Section(-2.7, 2.025, -3.0, 2.25, 0.3),
    Section(-2.7, 1.8, -3.0, 1.8, 0.3),
    Section(-2.7, 1.575, -3.0, 1.35, 0.3),
    Section(-2.5, 1.125, -2.65, 0.9375, 0.3),
    Section(-2.0, 0.9, -1.9, 0.6, 0.3)
  )
  private val spout = Seq(
    Section(1.7, 1.425, 1.7, 0.6, 0.66),
    Section(2.6, 1.425, 3.1, 0.825, 0.66),
    Section(2.3, 2.1, 2.4, 2.025, 0.25),
    Section(2.7, 2.4, 3.3, 2.4, 0.25),
    Section(2.8, 2.475, 3.525, 2.49375, 0.25),
    Section(2.9, 2.475, 3.45, 2.5125, 0.15),
    Section(2.8, 2.4, 3.2, 2.4, 0.15)
  )

  val parts: Seq[Part] =
    revolved("rim", rim, 2) ++ revolved("body", shoulder, 4) ++ revolved("body", belly, 3) ++
      revolved("lid", knob, 3) ++ revolved("lid", lid, 2) ++ revolved("bottom", bottom, 2) ++
      swept("handle", handle.take(4), 5, 3) ++ swept("handle", handle.drop(3), 5, 3) ++
      swept("spout", spout.take(4), 4, 4) ++ swept("spout", spout.drop(3), 3, 4)

  /** Triangles of the whole teapot, front sides out, shifted so that y is up.
    *
    * @param tessellation
    *   steps of a quarter turn; the other directions follow in proportion
    * @param color
    *   vertex colour as a function of the normal
    */
  def triangles(
      tessellation: Int,
      color: Vector3 => (Double, Double, Double, Double)
  ): IndexedSeq[Triangle] = {
    def steps(atSix: Int) = (atSix * tessellation / 6.0).round.toInt.max(1)
    parts.toIndexedSeq.flatMap { part =>
      val (nu, nv) = (steps(part.stepsU), steps(part.stepsV))
      val grid = IndexedSeq.tabulate(nu + 1, nv + 1) { (i, j) =>
        val (u, v) = (i.toDouble / nu, j.toDouble / nv)
        val normal = upright(part.patch.normal(u, v))
        MeshVertex(upright(part.patch.point(u, v)), normal, v, 1 - u, color(normal))
      }
      Grid.triangles(grid, material = 0)
    }
  }

  private def upright(p: Vector3) = Vector3(p.x, p.z, -p.y)

  private def revolved(name: String, profile: Seq[Ring], steps: Int): Seq[Part] =
    (0 to 3).map { quarter =>
      def turned(x: Double, y: Double, z: Double) = quarter match {
        case 0 => Vector3(x, y, z)
        case 1 => Vector3(-y, x, z)
        case 2 => Vector3(-x, -y, z)
        case _ => Vector3(y, -x, z)
      }
      val control = profile.toIndexedSeq.map { case Ring(r, z, reach) =>
        IndexedSeq(turned(r, 0, z), turned(r, reach, z), turned(reach, r, z), turned(0, r, z))
      }
      Part(name, BezierPatch(control), steps, 6)
    }

  private def swept(name: String, sections: Seq[Section], stepsU: Int, stepsV: Int): Seq[Part] =
    Seq(1, -1).map { side =>
      val control = sections.toIndexedSeq.map { case Section(x0, z0, x1, z1, w) =>
        val half = IndexedSeq(
          Vector3(x0, 0, z0),
          Vector3(x0, side * w, z0),
          Vector3(x1, side * w, z1),
          Vector3(x1, 0, z1)
        )
        if (side > 0) half else half.reverse
      }
      Part(name, BezierPatch(control), stepsU, stepsV)
    }
}
