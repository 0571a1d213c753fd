package frustum.scene

import frustum.contract.raster.Combine
import frustum.driver.linear.Vector3
import frustum.driver.scene.{Camera, Material, Scene, TextureImage, Triangle}

/** A brick corridor with repeated textures, panes of coloured glass (blended) and a grille (alpha-tested) in
  * front of its end. Vertex colours darken into the depth.
  */
object Corridor {
  private val (halfWidth, height, length) = (1.5, 3.0, 20.0)

  def scene: Scene = {
    val triangles = walls ++ grille ++ panes
    val camera =
      Camera(Vector3(0.25, 1.65, 1.9), Vector3(0, 1.4, -8), Vector3(0, 1, 0), 62, 0.1, 40)
    Scene("corridor", triangles, materials, camera, 0x000000)
  }

  private val materials: IndexedSeq[Material] = IndexedSeq(
    textured("bricks", Pictures.bricks),
    textured("slabs", Pictures.slabs),
    textured("grille", Pictures.grille).copy(alphaTest = Some(0.5)),
    glass("blue glass", (0.25, 0.5, 1.0)),
    glass("green glass", (0.2, 0.9, 0.45)),
    glass("amber glass", (1.0, 0.65, 0.15))
  )

  private def textured(name: String, picture: TextureImage) =
    Material(name, (1, 1, 1), 1, Some(picture), Combine.Modulate, blend = false, None)

  private def glass(name: String, color: (Double, Double, Double)) =
    Material(name, color, 0.42, None, Combine.ColorOnly, blend = true, None)

  /** Lamps near the viewer and at the far end, the middle darker. */
  private def lit(base: Double)(p: Vector3) = {
    val depth = (-p.z / length).max(0.0)
    val f = base * (0.35 + 0.65 * (2 * depth - 1) * (2 * depth - 1))
    (f, f * 0.97, f * 0.9, 1.0)
  }

  private def walls: IndexedSeq[Triangle] = {
    val along = Vector3(0, 0, -length - 2)
    val up = Vector3(0, height, 0)
    val right = Vector3(2 * halfWidth, 0, 0)
    val (nearLeft, nearRight) = (Vector3(-halfWidth, 0, 2), Vector3(halfWidth, 0, 2))
    val end = Vector3(-halfWidth, 0, -length)
    val leftWall = Grid.rectangle(nearLeft, along, up, (11, 1.5), (11, 1), 0)(lit(0.95))
    val rightWall = Grid.rectangle(
      nearRight + along,
      -along,
      up,
      (11, 1.5),
      (11, 1),
      0
    )(lit(0.8))
    val floor = Grid.rectangle(nearLeft, right, along, (1.5, 11), (1, 11), 1)(lit(1))
    val ceiling =
      Grid.rectangle(nearLeft + up, along, right, (11, 1.5), (11, 1), 1)(lit(0.6))
    val endWall = Grid.rectangle(end, right, up, (1.5, 1.5), (1, 1), 0)(lit(1))
    leftWall ++ rightWall ++ floor ++ ceiling ++ endWall
  }

  private def grille: IndexedSeq[Triangle] =
    Grid.rectangle(
      Vector3(-halfWidth, 0, -9),
      Vector3(2 * halfWidth, 0, 0),
      Vector3(0, 2.2, 0),
      (4, 3),
      (1, 1),
      2
    )(lit(1.6)(_) match { case (r, g, b, a) => (r.min(1.0), g.min(1.0), b.min(1.0), a) })

  /** Listed front to back on purpose: the driver sorts what is blended. */
  private def panes: IndexedSeq[Triangle] = {
    def pane(material: Int, x: Double, z: Double) =
      Grid.rectangle(
        Vector3(x, 0, z),
        Vector3(1.7, 0, 0),
        Vector3(0, 2.4, 0),
        (1, 1),
        (1, 1),
        material
      )(p => { val f = 0.7 + 0.3 * p.y / 2.4; (f, f, f, 1.0) })
    pane(3, -1.5, -2.5) ++ pane(4, -0.2, -5) ++ pane(5, -0.6, -7.2)
  }
}
