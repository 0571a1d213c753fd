package frustum.scene

import frustum.contract.InputError
import frustum.contract.raster.RasterConfig
import frustum.driver.linear.Vector3
import frustum.driver.scene.{BoundingSphere, Material, MeshVertex, Scene, SceneOrigin, Triangle}
import frustum.files.Notices
import java.nio.file.Path

/** Scenes from OBJ files with their MTL files and pictures. */
object ObjScene {

  /** How a mesh is read.
    *
    * @param texture     a picture for all faces in place of the materials' own
    * @param textureSize side for pictures of sizes that the hardware does not take, see [[TextureSizes]]
    * @param texels      of the hardware's texel memory
    * @param aspect      width / height of the picture that the mesh is framed for
    */
  final case class Options(
      texture: Option[Path] = None,
      textureSize: Option[Int] = None,
      texels: Int = RasterConfig().textureTexels,
      aspect: Double = RasterConfig().width.toDouble / RasterConfig().height
  )

  /** Reads a mesh. Polygons become triangles, also where corners point inwards; a face without normals is flat, one
    * without a material white, one without texture coordinates shows its material's colour. The mesh is framed, see
    * [[Framing]]. What was skipped or replaced is in the scene's notices.
    *
    * @throws frustum.contract.InputError
    *   naming file, line, what is wrong and the remedy
    */
  def read(file: Path, options: Options = Options()): Scene = {
    val notices = new Notices
    val obj = ObjFile.read(file, notices)
    if (obj.faces.isEmpty) {
      val instead = notices.result.headOption.fold("")(n => s"; ${n.what}")
      throw InputError(s"$file: there are no faces ('f' lines); give a mesh of polygons$instead")
    }
    for (picture <- options.texture if !obj.faces.exists(textured))
      throw InputError(
        s"$file: no face has texture coordinates, so $picture cannot be applied; add them or leave the picture out"
      )
    val looks = new FaceMaterials(obj, options, notices)
    val ofFace = obj.faces.map(looks(_))
    val materials = ofFace.distinct
    val index = materials.zipWithIndex.toMap
    val triangles = obj.faces.zip(ofFace).flatMap { case (face, material) => cut(face, index(material), notices) }
    val lines = obj.faces.flatMap(f => IndexedSeq.fill(f.corners.length - 2)(f.line.number))
    noticeInvisible(obj, ofFace, notices)
    Scene(
      file.getFileName.toString,
      triangles,
      materials,
      Framing(BoundingSphere(triangles.flatMap(_.vertices.map(_.position))), options.aspect),
      0x000000,
      Some(SceneOrigin(file, lines)),
      notices.result
    )
  }

  /** Whether a picture can lie on a face. */
  private[scene] def textured(face: ObjFile.Face): Boolean = face.corners.forall(_.texture.isDefined)

  private def cut(face: ObjFile.Face, material: Int, notices: Notices): IndexedSeq[Triangle] = {
    val flat = faceNormal(face.corners.map(_.position))
    val map = face.material.flatMap(m => m.map.orElse(m.alphaMap))
    val vertices = face.corners.map { c =>
      val (u, v) = c.texture.getOrElse((0.0, 0.0))
      val (s, t) = map.fold((u, v))(_.coordinates(u, v))
      MeshVertex(c.position, c.normal.getOrElse(flat), s, t, c.color)
    }
    val cuts = Triangulation(face.corners.map(_.position), flat)
    if (cuts.crossed)
      notices.at(
        face.line.place,
        "a polygon crosses itself, so what of it is filled is not defined; cut it into simple ones"
      )
    cuts.triangles.toIndexedSeq.map { case (a, b, c) => Triangle(vertices(a), vertices(b), vertices(c), material) }
  }

  /** Nothing is seen of some faces, or of all: never in silence. */
  private def noticeInvisible(obj: ObjFile, materials: IndexedSeq[Material], notices: Notices): Unit = {
    def clear(alpha: Double) = alpha < MtlFile.HalfLevel
    def invisible(f: ObjFile.Face, m: Material) =
      clear(m.alpha) || m.texture.exists(_.argb.forall(_ >>> 24 == 0)) || f.corners.forall(c => clear(c.color._4))
    val unseen = obj.faces.zip(materials).filter { case (f, m) => invisible(f, m) }
    for ((f, m) <- unseen) {
      val whole = if (unseen.length == obj.faces.length) "the whole mesh" else s"a face of material '${m.name}'"
      notices.at(
        f.material.fold(f.line.place)(_.line.place),
        s"$whole is wholly transparent ('d 0', 'Tr 1' or its picture), so nothing of it is seen; write 'd 1' for " +
          "opaque",
        s"transparent ${m.name}"
      )
    }
  }

  /** Normal of a polygon by Newell's sums, which need no corner to be convex. Where they cancel, as in a
    * quadrilateral that crosses itself, that of the largest of the triangles they are made of; (0, 1, 0) where all
    * corners lie on a line.
    */
  private def faceNormal(p: IndexedSeq[Vector3]): Vector3 = {
    val crosses = p.indices.map { i =>
      (p(i) - p(0)).cross(p((i + 1) % p.length) - p(0))
    }
    val sum = crosses.reduce(_ + _)
    val largest = crosses.maxBy(_.length)
    if (sum.length > 1e-9 * largest.length) sum.normalized
    else if (largest.length > 0) largest.normalized
    else Vector3(0, 1, 0)
  }
}
