package frustum.scene

import frustum.driver.scene.{MeshVertex, Triangle}
import org.joml.Vector3d

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
      corner: Vector3d,
      side1: Vector3d,
      side2: Vector3d,
      repeats: (Double, Double),
      steps: (Int, Int),
      material: Int
  )(color: Vector3d => (Double, Double, Double, Double)): IndexedSeq[Triangle] = {
    val normal = new Vector3d(side1).cross(side2).normalize
    val rows = IndexedSeq.tabulate(steps._1 + 1, steps._2 + 1) { (i, j) =>
      val (f, g) = (i.toDouble / steps._1, j.toDouble / steps._2)
      val p = new Vector3d(corner).fma(f, side1).fma(g, side2)
      MeshVertex(p, normal, f * repeats._1, g * repeats._2, color(p))
    }
    triangles(rows, material)
  }

  /** Unit normal of the face, or None when it has no area. */
  def faceNormal(t: Triangle): Option[Vector3d] = {
    val e1 = new Vector3d(t.v1.position).sub(t.v0.position)
    val e2 = new Vector3d(t.v2.position).sub(t.v0.position)
    val n = new Vector3d(e1).cross(e2)
    val extent = e1.lengthSquared.max(e2.lengthSquared)
    // rounding leaves corners that should coincide apart by some 1e-16 of the size
    if (n.length <= 1e-12 * extent) None else Some(n.normalize)
  }
}
