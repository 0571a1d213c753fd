package frustum.scene

import frustum.driver.linear.Vector3
import frustum.driver.scene.{MeshVertex, Triangle}

/** Triangles from rows of vertices. */
object Grid {

  /** Two triangles for each cell of `rows`, front side where row direction times column direction points to;
    * a triangle without area (two corners in one place) is left out.
    */
  def triangles(rows: IndexedSeq[IndexedSeq[MeshVertex]], material: Int): IndexedSeq[Triangle] =
    for {
      i <- 0 until rows.length - 1
      j <- 0 until rows(i).length - 1
      (a, b, c, d) = (rows(i)(j), rows(i + 1)(j), rows(i + 1)(j + 1), rows(i)(j + 1))
      triangle <- Seq(Triangle(a, b, c, material), Triangle(a, c, d, material))
      if faceNormal(triangle).isDefined
    } yield triangle

  /** A flat rectangle: corner, its two sides (front where side1 x side2 points to), texture repeats along
    * them, cut into steps; colour as a function of position.
    */
  def rectangle(
      corner: Vector3,
      side1: Vector3,
      side2: Vector3,
      repeats: (Double, Double),
      steps: (Int, Int),
      material: Int
  )(color: Vector3 => (Double, Double, Double, Double)): IndexedSeq[Triangle] = {
    val normal = side1.cross(side2).normalized
    val rows = IndexedSeq.tabulate(steps._1 + 1, steps._2 + 1) { (i, j) =>
      val (f, g) = (i.toDouble / steps._1, j.toDouble / steps._2)
      val p = corner + side1 * f + side2 * g
      MeshVertex(p, normal, f * repeats._1, g * repeats._2, color(p))
    }
    triangles(rows, material)
  }

  /** Unit normal of the face, or None when it has no area. */
  def faceNormal(t: Triangle): Option[Vector3] = {
    val e1 = t.v1.position - t.v0.position
    val e2 = t.v2.position - t.v0.position
    val n = e1.cross(e2)
    val extent = e1.dot(e1).max(e2.dot(e2))
    // rounding leaves corners that should coincide apart by some 1e-16 of the size
    if (n.length <= 1e-12 * extent) None else Some(n.normalized)
  }
}
