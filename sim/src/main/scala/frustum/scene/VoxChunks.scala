package frustum.scene

import frustum.contract.InputError
import frustum.files.InputFile
import java.nio.file.Path

/** Reads the chunks of a MagicaVoxel .vox file (format 150 and 200, github.com/ephtracy/voxel-model). Of animations
  * the first frame is read. IMAP orders the editor's palette and changes no voxel's colour: voxels index RGBA
  * directly.
  */
object VoxChunks {

  /** Chunks without any bearing on what is where in which colour. */
  private val Skipped = Set("MAIN", "PACK", "IMAP", "NOTE", "rOBJ", "rCAM", "META")

  def read(file: Path): VoxContent = {
    val all = InputFile.bytes(file, "check the file")
    if (all.length < 8 || new String(all, 0, 4, "ISO-8859-1") != "VOX ")
      throw InputError(s"$file: byte 0: is not a MagicaVoxel file; its first bytes are not 'VOX '")
    new VoxChunks(file, all).chunks(8, all.length)
  }
}

private final class VoxChunks(file: Path, all: Array[Byte]) {
  private var content = VoxContent()
  private var openSize = Option.empty[(Seq[Int], VoxBytes)] // SIZE whose XYZI is to come

  def chunks(from: Int, until: Int): VoxContent = {
    var at = from
    while (at < until) {
      val header = new VoxBytes(file, all, "header", at, until)
      val kind = Seq.fill(4)(header.unsignedByte().toChar).mkString
      val length = header.int()
      val children = header.int()
      val body = at + 12
      def within(place: Int, n: Int, what: String): Unit = if (n < 0 || place + n.toLong > until)
        header.refuse(s"$what of chunk $kind ends beyond the file's ${all.length} bytes; save it again", place)
      within(body, length, "the content")
      within(body + length, children, "what is inside")
      chunk(new VoxBytes(file, all, kind, body, body + length))
      if (kind == "MAIN") chunks(body + length, body + length + children)
      at = body + length + children
    }
    openSize.foreach { case (_, chunk) =>
      chunk.refuse("chunk SIZE without an XYZI: a model without voxels; save it again")
    }
    content
  }

  private def chunk(c: VoxBytes): Unit = c.kind match {
    case "SIZE"                          => openSize = Some((Seq.fill(3)(c.int()), c))
    case "XYZI"                          => content = content.copy(models = content.models :+ model(c))
    case "RGBA"                          => content = content.copy(palette = palette(c))
    case "nTRN"                          => node(c)(transform)
    case "nGRP"                          => node(c)(group)
    case "nSHP"                          => node(c)(shape)
    case "LAYR"                          => layer(c)
    case "MATL"                          => material(c.int() & 255, newMaterial(c.dictionary()))
    case "MATT"                          => material(c.int() & 255, oldMaterial(c))
    case kind if VoxChunks.Skipped(kind) =>
    case kind                            => content = content.copy(unknown = content.unknown :+ kind)
  }

  private def model(c: VoxBytes): VoxModel = {
    val (size, _) = openSize.getOrElse(c.refuse("chunk XYZI without a SIZE before it; save it again"))
    openSize = None
    val box = size.mkString("x")
    if (size.exists(n => n < 1 || n > 256)) c.refuse(s"a model of $box: each side must be 1 to 256; save it again")
    val voxels = IndexedSeq.fill(c.count("voxels", 4))(
      VoxVoxel(c.unsignedByte(), c.unsignedByte(), c.unsignedByte(), c.unsignedByte())
    )
    voxels.find(v => v.x >= size(0) || v.y >= size(1) || v.z >= size(2)).foreach(v =>
      c.refuse(s"voxel (${v.x}, ${v.y}, ${v.z}) lies outside its model of $box; save it again")
    )
    VoxModel(size, voxels.filter(_.color != 0))
  }

  /** Entry 0 is that of colour index 1; the last one has no index. */
  private def palette(c: VoxBytes): IndexedSeq[Int] = 0 +: IndexedSeq.fill(256) {
    val rgb = (0 to 2).map(_ => c.unsignedByte()).foldLeft(0)(_ << 8 | _)
    c.unsignedByte() // alpha: the editor takes no notice of it
    rgb
  }.init

  private def node(c: VoxBytes)(read: (VoxBytes, Boolean) => VoxNode): Unit = {
    val id = c.int()
    val attributes = c.dictionary()
    if (content.nodes.contains(id)) c.refuse(s"there are two nodes $id; save it again")
    val node = read(c, hidden(attributes)) // changes `content` itself where it counts frames
    content = content.copy(nodes = content.nodes.updated(id, node))
  }
  private def hidden(attributes: Map[String, String]) = attributes.get("_hidden").contains("1")

  private def transform(c: VoxBytes, hidden: Boolean): VoxNode = {
    val (child, _, layer) = (c.int(), c.int(), c.int())
    VoxTransform(child, layer, hidden, first(c, "frames")(placement(c, c.dictionary())))
  }

  private def placement(c: VoxBytes, frame: Map[String, String]): VoxPlacement = {
    val rotation = frame.get("_r").fold(VoxPlacement.Identity)(r =>
      r.toIntOption.flatMap(VoxPlacement.rotation).getOrElse(c.refuse(s"'$r' is no rotation; save it again"))
    )
    val shift = frame.get("_t").fold(Seq(0, 0, 0))(t =>
      t.trim.split("\\s+").toSeq.map(_.toIntOption.filter(_.abs <= VoxPlacement.MostShift)) match {
        case Seq(Some(x), Some(y), Some(z)) => Seq(x, y, z)
        case _                              =>
          c.refuse(
            s"'$t' is no translation of at most ${VoxPlacement.MostShift} voxels; move the model and save it again"
          )
      }
    )
    rotation.copy(shift = shift)
  }

  private def group(c: VoxBytes, hidden: Boolean): VoxNode =
    VoxGroup(Seq.fill(c.count("children", 4))(c.int()), hidden)

  private def shape(c: VoxBytes, hidden: Boolean): VoxNode = VoxShape(
    first(c, "models") {
      val model = c.int()
      c.dictionary()
      model
    },
    hidden
  )

  /** The first of some frames, the others being counted. */
  private def first[A](c: VoxBytes, what: String)(read: => A): A = {
    val n = c.count(what, 4)
    if (n == 0) c.refuse(s"a node without $what; save it again")
    val frames = Seq.fill(n)(read)
    content = content.copy(frames = content.frames + n - 1)
    frames.head
  }

  private def layer(c: VoxBytes): Unit = {
    val id = c.int()
    if (hidden(c.dictionary())) content = content.copy(hiddenLayers = content.hiddenLayers + id)
  }

  private def material(id: Int, m: VoxMaterial): Unit =
    content = content.copy(materials = content.materials.updated(id, m))

  /** Releases of the editor name the transparency of glass differently; it is a half where none is given. */
  private def newMaterial(properties: Map[String, String]) = VoxMaterial(
    properties.getOrElse("_type", "_diffuse").stripPrefix("_"),
    Seq("_trans", "_alpha", "_weight").flatMap(properties.get).flatMap(_.toDoubleOption).find(_.isFinite).getOrElse(0.5)
  )

  /** Of files before the scene graph. */
  private def oldMaterial(c: VoxBytes) = {
    val (kind, weight) = (c.int(), c.float())
    VoxMaterial(IndexedSeq("diffuse", "metal", "glass", "emit").lift(kind).getOrElse(s"kind $kind"), weight.toDouble)
  }
}
