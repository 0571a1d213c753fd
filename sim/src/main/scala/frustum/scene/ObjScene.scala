package frustum.scene

import frustum.contract.InputError
import frustum.contract.raster.Combine
import frustum.driver.scene.{BoundingSphere, Camera, Material, MeshVertex, Scene, SceneOrigin, Triangle}
import org.joml.Vector3d
import java.nio.file.Path

/** Scenes from OBJ files with their MTL and PNG files. */
object ObjScene {

  /** Reads a mesh. Polygons become triangles, also where corners point inwards; a face without normals is flat, one without a material
    * white, one without texture coordinates shows its material's colour. Without a camera of its own the mesh
    * is framed, see [[framing]].
    *
    * @param textureOverride
    *   a picture for all faces in place of the materials' own
    * @throws frustum.contract.InputError
    *   naming file, line, what is wrong and the remedy
    */
  def read(file: Path, textureOverride: Option[Path]): Scene = {
    val obj = ObjFile.read(file)
    val picture = textureOverride.map(TextureFile.read(_))
    if (obj.faces.isEmpty) throw InputError(s"$file: there are no faces ('f' lines); give a mesh of polygons")
    if (picture.isDefined && !obj.faces.exists(textured))
      throw InputError(
        s"$file: no face has texture coordinates, so ${textureOverride.get} cannot be applied; " +
          "add them or leave the picture out"
      )
    def materialOf(face: ObjFile.Face): Material = {
      val m = face.material.getOrElse(Material.White)
      if (!textured(face))
        m.copy(texture = None, combine = Combine.ColorOnly, alphaTest = None, blend = m.alpha < 1)
      else picture.fold(m)(p => Material.textured(m.name, p, m.alpha))
    }
    val ofFace = obj.faces.map(materialOf)
    val materials = ofFace.distinct
    val index = materials.zipWithIndex.toMap
    val triangles = obj.faces.zip(ofFace).flatMap { case (face, material) => cut(face, index(material)) }
    val lines = obj.faces.flatMap(f => IndexedSeq.fill(f.corners.length - 2)(f.line.number))
    Scene(
      file.getFileName.toString,
      triangles,
      materials,
      framing(triangles),
      0x000000,
      Some(SceneOrigin(file, lines))
    )
  }

  /** The camera for a mesh that has none: from c + 2.5 r (0.45, 0.35, 0.82) towards c, near 0.05 r and far 10
    * r, where c and r are centre and radius of the bounding sphere.
    */
  def framing(triangles: IndexedSeq[Triangle]): Camera = {
    val (centre, extent) = BoundingSphere(triangles.flatMap(_.vertices.map(_.position)))
    val radius = if (extent > 0) extent else 1.0
    val eye = new Vector3d(0.45, 0.35, 0.82).mul(2.5 * radius).add(centre)
    Camera(eye, centre, new Vector3d(0, 1, 0), 45, 0.05 * radius, 10 * radius)
  }

  private def textured(face: ObjFile.Face): Boolean = face.corners.forall(_.texture.isDefined)

  private def cut(face: ObjFile.Face, material: Int): IndexedSeq[Triangle] = {
    val flat = faceNormal(face.corners.map(_.position))
    val vertices = face.corners.map { c =>
      val normal = c.normal.filter(_.length > 0).fold(flat)(n => new Vector3d(n).normalize)
      val (s, t) = c.texture.getOrElse((0.0, 0.0))
      MeshVertex(c.position, normal, s, t, (c.color._1, c.color._2, c.color._3, 1.0))
    }
    Triangulation(face.corners.map(_.position), flat).toIndexedSeq.map { case (a, b, c) =>
      Triangle(vertices(a), vertices(b), vertices(c), material)
    }
  }

  /** Normal of a polygon by Newell's sums, which need no corner to be convex; (0, 1, 0) where it has no area.
    */
  private def faceNormal(p: IndexedSeq[Vector3d]): Vector3d = {
    val sum = new Vector3d
    for (i <- p.indices) {
      val a = new Vector3d(p(i)).sub(p(0))
      val b = new Vector3d(p((i + 1) % p.length)).sub(p(0))
      sum.add(a.cross(b))
    }
    if (sum.length > 0) sum.normalize else new Vector3d(0, 1, 0)
  }
}
