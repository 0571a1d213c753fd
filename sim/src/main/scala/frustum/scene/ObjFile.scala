package frustum.scene

import frustum.driver.linear.Vector3
import frustum.files.Notices
import java.nio.file.Path
import scala.collection.mutable

/** The content of an OBJ file: polygons with their vertices looked up, in file order. */
final case class ObjFile(faces: IndexedSeq[ObjFile.Face])

/** Reader of the polygons of OBJ files. Written for its messages: readers we know of neither name the line
  * nor keep more than single precision.
  */
object ObjFile {

  /** A corner of a polygon; what the file leaves out, or has as "not a number", is None.
    *
    * @param color red, green, blue, alpha, 0..1
    */
  final case class Corner(
      position: Vector3,
      texture: Option[(Double, Double)],
      normal: Option[Vector3],
      color: (Double, Double, Double, Double)
  )

  /** A polygon, and the material in force, None where there is none. */
  final case class Face(corners: IndexedSeq[Corner], material: Option[MtlMaterial], line: SourceLine)

  /** Statements that do not change what is drawn here. */
  private val Silent =
    Set("g", "o", "s", "mg", "bevel", "c_interp", "d_interp", "lod", "maplib", "usemap", "shadow_obj", "trace_obj")

  private val Curves = Set(
    "vp",
    "cstype",
    "deg",
    "bmat",
    "step",
    "curv",
    "curv2",
    "surf",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "ctech",
    "stech",
    "bsp",
    "bzp",
    "cdc",
    "cdp",
    "res"
  )

  /** Polygons of a file; what does not concern their shape is skipped or replaced with a notice.
    *
    * InputError naming file, line, what is wrong there and what would be right.
    */
  def read(file: Path, notices: Notices): ObjFile = new ObjReader(notices).read(file)

  /** The state of reading one file. */
  private final class ObjReader(notices: Notices) {
    private val positions = mutable.ArrayBuffer.empty[(Vector3, (Double, Double, Double, Double))]
    private val textures = mutable.ArrayBuffer.empty[Option[(Double, Double)]]
    private val normals = mutable.ArrayBuffer.empty[Option[Vector3]]
    private val faces = mutable.ArrayBuffer.empty[(IndexedSeq[Corner], Option[SourceLine], SourceLine)]
    private val vertices = new ObjVertices(notices)
    private val materials = new MaterialNames(notices)
    private var current = Option.empty[SourceLine]

    def read(file: Path): ObjFile = {
      SourceLine.read(file).foreach(statement)
      ObjFile(faces.iterator.map { case (corners, named, line) =>
        Face(corners, named.flatMap(materials.named), line)
      }.toIndexedSeq)
    }

    private def statement(line: SourceLine): Unit = line.keyword match {
      case "v"                 => positions += vertices.position(line)
      case "vt"                => textures += vertices.texture(line)
      case "vn"                => normals += vertices.normal(line)
      case "f" | "fo"          => face(line)
      case "mtllib"            => materials.library(line)
      case "usemtl"            => current = Some(line)
      case "l"                 => skip(line, "lines ('l', or faces of two corners)")
      case "p"                 => skip(line, "points ('p', or faces of one corner)")
      case k if Curves(k)      => skip(line, "curves and surfaces")
      case k if Silent(k)      =>
      case k if k.length <= 32 =>
        notices.at(line.place, s"statement '$k' is not known and skipped; check the file", "unknown")
      case _ => line.error("is not a statement of OBJ; give an OBJ file in text form")
    }

    private def skip(line: SourceLine, what: String): Unit =
      notices.at(line.place, s"$what are skipped, only polygons are drawn; export the mesh as polygons")

    private def face(line: SourceLine): Unit = {
      val corners = line.words.map(corner(line, _))
      corners.length match {
        case 0 => line.error("face without vertices; write at least 3")
        case 1 => skip(line, "points ('p', or faces of one corner)")
        case 2 => skip(line, "lines ('l', or faces of two corners)")
        case _ => faces += ((corners, current, line))
      }
    }

    private def corner(line: SourceLine, word: String): Corner = {
      val parts = word.split("/", -1)
      if (parts.length > 3) line.error(s"'$word' in a face; write v, v/vt, v//vn or v/vt/vn")
      def index(part: Int, what: String, count: Int): Option[Int] =
        if (part >= parts.length || (part > 0 && parts(part).isEmpty)) None
        else {
          if (!parts(part).matches("[+-]?\\d+"))
            line.error(s"'$word' in a face is not made of whole numbers; write v, v/vt, v//vn or v/vt/vn")
          val i = BigInt(parts(part).stripPrefix("+"))
          if (i == 0) line.error(s"face names $what 0; numbers start at 1 (or -1 for the latest)")
          val found = if (i > 0) i - 1 else count + i
          if (found < 0 || found >= count)
            line.error(s"face names $what $i of $count; name one that is defined above this line")
          Some(found.toInt)
        }
      val (position, color) = positions(index(0, "vertex", positions.length).get)
      Corner(
        position,
        index(1, "texture coordinate", textures.length).flatMap(textures),
        index(2, "normal", normals.length).flatMap(normals),
        color
      )
    }
  }
}
