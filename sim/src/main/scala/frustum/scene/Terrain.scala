package frustum.scene

import frustum.contract.raster.Combine
import frustum.driver.linear.Vector3
import frustum.driver.scene.{Camera, Material, MeshVertex, Scene}
import frustum.scene.Pictures.Rgb
import scala.math.{cos, max, sin}

/** A bay among hills: a height field of 25 x 20 cells, 1,000 triangles, smooth colours modulating a grain
  * texture.
  */
object Terrain {
  private val (columns, rows, cell) = (25, 20, 1.0)

  def scene: Scene = {
    val grid = IndexedSeq.tabulate(rows + 1, columns + 1) { (i, j) =>
      val (x, z) = ((j - columns / 2.0) * cell, (i - rows / 2.0) * cell)
      MeshVertex(ground(x, z), normal(x, z), j / 2.0, (rows - i) / 2.0, color(x, z))
    }
    val material =
      Material("grain", (1, 1, 1), 1, Some(Pictures.grain), Combine.Modulate, blend = false, None)
    val camera =
      Camera(Vector3(1, 6.5, 14.5), Vector3(0.4, 1.2, 0), Vector3(0, 1, 0), 52, 1, 60)
    Scene("terrain", Grid.triangles(grid, 0), IndexedSeq(material), camera, 0x9cc4e8)
  }

  /** Height before the sea fills what lies below 0. */
  private def relief(x: Double, z: Double): Double =
    1.5 * sin(0.42 * x + 0.7) * cos(0.37 * z - 0.4) + 0.8 * sin(0.9 * x - 0.55 * z + 1.1) +
      0.35 * cos(1.7 * x + 1.3 * z) - 0.07 * z + 0.35

  private def ground(x: Double, z: Double) = Vector3(x, max(0.0, relief(x, z)), z)

  private def normal(x: Double, z: Double): Vector3 = {
    val step = 0.5 * cell
    val slopeX = ground(x + step, z).y - ground(x - step, z).y
    val slopeZ = ground(x, z + step).y - ground(x, z - step).y
    Vector3(-slopeX, 2 * step, -slopeZ).normalized
  }

  /** Colour by height, darkened on slopes that face away from the sun. */
  private def color(x: Double, z: Double): (Double, Double, Double, Double) = {
    val h = relief(x, z)
    val bands: Seq[(Double, Rgb)] = Seq(
      (-2.5, (0.05, 0.18, 0.45)),
      (-0.05, (0.16, 0.5, 0.72)),
      (0.1, (0.9, 0.83, 0.58)),
      (0.5, (0.42, 0.62, 0.24)),
      (1.5, (0.2, 0.46, 0.18)),
      (2.2, (0.5, 0.45, 0.4)),
      (2.9, (1.0, 1.0, 1.0))
    )
    val i = bands.indexWhere(_._1 >= h) match { case -1 => bands.length - 1; case 0 => 1; case n => n }
    val ((h0, c0), (h1, c1)) = (bands(i - 1), bands(i))
    val f = ((h - h0) / (h1 - h0)).max(0.0).min(1.0)
    val sun = 0.45 + 0.65 * max(0.0, normal(x, z).dot(Vector3(-0.6, 0.7, 0.25).normalized))
    def mix(a: Double, b: Double) = ((a + (b - a) * f) * sun).min(1.0)
    (mix(c0._1, c1._1), mix(c0._2, c1._2), mix(c0._3, c1._3), 1)
  }
}
