package frustum.model.ray

import frustum.contract.ray.{RayMotion, RayPaint, RayProgram, RayScene, RayShade, Wall}
import frustum.model.ray.program.RaySetup
import frustum.model.ray.shade.SphereShade

/** What a ray caster says of a pixel: object (0 background, 1 wall, then quads, then spheres) and colour. */
case class RayPixel(rgb: Int, objectId: Int)

/** Bit-exact model of the ray caster. */
class RayPicture(scene: RayScene, width: Int, height: Int) {
  private val program = RayProgram(scene, width, height)
  private val setup = new RaySetup(program, scene, width, height)
  private val forms = program.forms.toArray
  private val index = forms.map(_.name).zipWithIndex.toMap
  private val room = scene.room
  private val value = new Array[Long](forms.length)
  private val step = new Array[Long](forms.length)
  private val curve = new Array[Long](forms.length)
  private def apply(name: String): Long = value(index(name))

  private val direction = (0 to 2).map(a => index(s"direction$a"))
  private val across = Wall.all.map(w => w.across.map(u => index(s"across${w.index}_$u")))
  private val quads = scene.quads.indices.map(i => (0 to 1).map(u => index(s"quad${i}_$u")))
  private val spheres = scene.spheres.indices.map(i => (index(s"sphere$i"), index(s"along$i")))
  private val lit = scene.light.isDefined
  private val format = RayShade(scene, program, width, height)
  private val shade = format.map(new SphereShade(_))
  private val ramps = format.toSeq.flatMap(s => scene.spheres.indices.map(s.ramp))
  private val shadows = scene.spheres.indices.map { i =>
    if (!lit) Nil else Wall.all.map(w => (index(s"shadow${i}_${w.index}"), index(s"gate${i}_${w.index}")))
  }

  def apply(motion: RayMotion): Array[RayPixel] = {
    setup.frame(motion)
    Array.tabulate(height) { _ =>
      val words = setup.row()
      for ((f, i) <- forms.zipWithIndex) {
        def start(difference: Int): Long =
          if (difference < f.loaded) words(f.first + f.slot(difference))
          else f.start.lift(difference).flatten.fold(0L)(_.toLong)
        value(i) = start(0)
        step(i) = start(1)
        curve(i) = start(2)
      }
      Array.fill(width) {
        val p = pixel()
        var i = 0
        while (i < forms.length) { value(i) += step(i); step(i) += curve(i); i += 1 }
        p
      }
    }.flatten
  }

  private def paint(paint: RayPaint, w: Wall, forms: Seq[Int], n: Long): Int =
    SurfacePaint(paint, w, room, j => value(forms(j)), n)

  private def pixel(): RayPixel = {
    val hitSpheres = spheres.indices.filter(i => value(spheres(i)._1) >= 0 && value(spheres(i)._2) > 0)
    if (hitSpheres.nonEmpty) {
      val i = hitSpheres.minBy(i => value(spheres(i)._2))
      val color = shade.fold(scene.spheres(i).color) { s =>
        ramps(i)(s(
          apply(s"sphere$i"),
          apply(s"towards$i"),
          apply(s"lit$i"),
          apply("square"),
          apply(s"power$i")
        ))
      }
      return RayPixel(color, 2 + quads.size + i)
    }
    val wall = Wall.all.find { w =>
      val n = w.sign * value(direction(w.axis))
      n > 0 && w.across.indices.forall { j =>
        val u = value(across(w.index)(j))
        u >= 0 && (room.high(w.across(j)) - room.low(w.across(j))).toLong * n - u >= 0
      }
    }
    wall match {
      case None    => RayPixel(scene.background, 0)
      case Some(w) =>
        val shadowed = shadows.indices.exists { i =>
          lit && {
            val (q, gate) = shadows(i)(w.index)
            apply(s"power$i") <= 0 || (value(gate) > 0 && value(q) >= 0)
          }
        }
        val n = w.sign * value(direction(w.axis))
        val quad = if (w != Wall.back) None
        else quads.indices.find { i =>
          quads(i).forall { f => value(f) >= 0 && 2L * scene.quads(i).half * n - value(f) >= 0 }
        }
        val color = quad match {
          case Some(i) => paint(scene.quads(i).paint, w, quads(i), n)
          case None    => paint(room.paints(w.index), w, across(w.index), n)
        }
        RayPixel(if (shadowed) SurfacePaint.darkened(color) else color, quad.fold(1)(2 + _))
    }
  }
}
