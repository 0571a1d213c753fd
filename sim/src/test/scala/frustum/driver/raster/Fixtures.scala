package frustum.driver.raster

import frustum.contract.raster.{RasterConfig, Wrap}
import frustum.driver.linear.{Vector3, Vector4}
import frustum.driver.scene.{Camera, Material, MeshVertex, Scene, TextureImage, Triangle}
import frustum.scene.{Grid, Pictures}

/** Small scenes and the options the host tests share. */
object Fixtures {
  val config: RasterConfig = RasterConfig()
  val options: DrawOptions = DrawOptions(light = None, cullBack = false, Wrap.Repeat, background = 0)

  /** One unit is one pixel, y up, the origin in the middle of the screen. */
  def pixelCamera(c: RasterConfig): Camera =
    Camera(
      Vector3(0, 0, 10),
      Vector3.Zero,
      Vector3(0, 1, 0),
      45,
      -500,
      500,
      orthoHeight = Some(c.height)
    )

  def vertex(x: Double, y: Double, z: Double = 0, s: Double = 0, t: Double = 0): MeshVertex =
    MeshVertex(Vector3(x, y, z), Vector3(0, 0, 1), s, t, (1, 1, 1, 1))

  def triangle(a: MeshVertex, b: MeshVertex, c: MeshVertex, material: Int = 0): Triangle =
    Triangle(a, b, c, material)

  def scene(triangles: Seq[Triangle], materials: Material*): Scene =
    Scene(
      "test",
      triangles.toIndexedSeq,
      if (materials.isEmpty) IndexedSeq(Material.White) else materials.toIndexedSeq,
      pixelCamera(config),
      0
    )

  def texture(width: Int, height: Int): TextureImage =
    Pictures.opaque(width, height)((x, y) => (x % 2, y % 2, 1))

  def textured(width: Int, height: Int): Material =
    Material.textured(s"$width x $height", texture(width, height), 1)

  def clipVertex(x: Double, y: Double, z: Double, w: Double, s: Double = 0, t: Double = 0): ClipVertex =
    ClipVertex(Vector4(x, y, z, w), s, t, Vector4(1, 1, 1, 1))

  def prepare(
      scene: Scene,
      options: DrawOptions = options,
      config: RasterConfig = config,
      frame: Int = 0
  ): PreparedFrame =
    Driver.prepare(scene, scene.camera, options, config, frame)

  /** A sphere with shared normals: poles, seam and all. */
  def sphere(rings: Int, segments: Int, radius: Double): IndexedSeq[Triangle] = {
    val rows = IndexedSeq.tabulate(rings + 1, segments + 1) { (i, j) =>
      val (theta, phi) = (scala.math.Pi * i / rings, 2 * scala.math.Pi * (j % segments) / segments)
      val flat = if (i == 0 || i == rings) 0.0 else scala.math.sin(theta)
      val n = Vector3(flat * scala.math.cos(phi), scala.math.cos(theta), -flat * scala.math.sin(phi))
      MeshVertex(n * radius, n, 0, 0, (1, 1, 1, 1))
    }
    Grid.triangles(rows, 0)
  }
}
