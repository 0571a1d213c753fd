package frustum.scene

import frustum.driver.scene.Material
import org.joml.Vector3d
import java.nio.file.Path
import scala.collection.mutable

/** The content of an OBJ file: polygons with their vertices looked up, in file order. */
final case class ObjFile(faces: IndexedSeq[ObjFile.Face], materials: Map[String, Material])

/** Reader of the polygons of OBJ files. Written for its messages: readers we know of neither name the line
  * nor keep more than single precision.
  */
object ObjFile {

  /** A corner of a polygon; what the file leaves out is None. */
  final case class Corner(
      position: Vector3d,
      texture: Option[(Double, Double)],
      normal: Option[Vector3d],
      color: (Double, Double, Double)
  )

  /** A polygon, and the material in force, None before the first `usemtl`. */
  final case class Face(corners: IndexedSeq[Corner], material: Option[Material], line: SourceLine)

  /** Statements that do not change what is drawn here. */
  private val skipped = Set(
    "g",
    "o",
    "s",
    "mg",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "maplib",
    "usemap",
    "shadow_obj",
    "trace_obj"
  )

  /** InputError naming file, line, what is wrong there and what would be right. */
  def read(file: Path): ObjFile = {
    val positions = mutable.ArrayBuffer.empty[(Vector3d, (Double, Double, Double))]
    val textures = mutable.ArrayBuffer.empty[(Double, Double)]
    val normals = mutable.ArrayBuffer.empty[Vector3d]
    val faces = mutable.ArrayBuffer.empty[Face]
    val materials = mutable.LinkedHashMap.empty[String, Material]
    var libraries = false
    var current: Option[Material] = None

    def corner(line: SourceLine, word: String): Corner = {
      val parts = word.split("/", -1)
      if (parts.length > 3) line.error(s"'$word' in a face; write v, v/vt, v//vn or v/vt/vn")
      def index(part: Int, what: String, count: Int): Option[Int] =
        if (part >= parts.length || (part > 0 && parts(part).isEmpty)) None
        else {
          val i = parts(part).toIntOption
            .getOrElse(
              line.error(s"'$word' in a face is not made of whole numbers; write v, v/vt, v//vn or v/vt/vn")
            )
          if (i == 0) line.error(s"face names $what 0; numbers start at 1 (or -1 for the latest)")
          val found = if (i > 0) i - 1 else count + i
          if (found < 0 || found >= count)
            line.error(
              s"face names $what $i of $count; name one that is defined above this line"
            )
          Some(found)
        }
      val (position, color) = positions(index(0, "vertex", positions.length).get)
      Corner(
        position,
        index(1, "texture coordinate", textures.length).map(textures),
        index(2, "normal", normals.length).map(normals),
        color
      )
    }

    for (line <- SourceLine.read(file)) line.keyword match {
      case "v" =>
        val n = line.numbers(3, 7, "x y z")
        val rgb = if (n.length >= 6) n.takeRight(3).map(_.max(0.0).min(1.0)) else IndexedSeq(1.0, 1.0, 1.0)
        if (n.take(3).exists(_.abs > 1e30)) line.error("a vertex beyond 1e30; scale the mesh down")
        positions += ((new Vector3d(n(0), n(1), n(2)), (rgb(0), rgb(1), rgb(2))))
      case "vt" =>
        val n = line.numbers(1, 3, "u v")
        textures += ((n(0), if (n.length > 1) n(1) else 0.0))
      case "vn" =>
        val n = line.numbers(3, 3, "x y z")
        normals += new Vector3d(n(0), n(1), n(2))
      case "f" =>
        if (line.words.length < 3) line.error(s"face with ${line.words.length} vertices; write at least 3")
        faces += Face(line.words.map(corner(line, _)), current, line)
      case "mtllib" =>
        if (line.text.isEmpty) line.error("'mtllib' without a file; write 'mtllib FILE.mtl'")
        libraries = true
        materials ++= MtlFile.read(MtlFile.beside(line), line)
      case "usemtl" =>
        current = materials.get(line.text)
        if (libraries && current.isEmpty)
          line.error(
            s"material '${line.text}' is in no mtllib above; there are: ${materials.keys.mkString(", ")}"
          )
      case k if skipped(k) =>
      case k               => line.error(s"statement '$k' is not supported; export the mesh as polygons (v, vt, vn, f)")
    }
    ObjFile(faces.toIndexedSeq, materials.toMap)
  }
}
