package frustum.scene

/** A model of a .vox file: its box in voxels, and its voxels, colour index 0 (empty) left out. */
final case class VoxModel(size: Seq[Int], voxels: IndexedSeq[VoxVoxel])

/** @param color index into the palette, 1 to 255 */
final case class VoxVoxel(x: Int, y: Int, z: Int, color: Int)

/** A node of the scene graph. */
sealed trait VoxNode { def hidden: Boolean }

/** nTRN: places its child; a hidden layer hides it. */
final case class VoxTransform(child: Int, layer: Int, hidden: Boolean, placement: VoxPlacement) extends VoxNode

/** nGRP. */
final case class VoxGroup(children: Seq[Int], hidden: Boolean) extends VoxNode

/** nSHP: shows a model. */
final case class VoxShape(model: Int, hidden: Boolean) extends VoxNode

/** How a colour of the palette is to look, from its MATL or MATT chunk.
  *
  * @param kind       `diffuse`, `metal`, `glass`, `emit`, `blend`, `media`
  * @param seeThrough share of light that glass lets through, 0 to 1
  */
final case class VoxMaterial(kind: String, seeThrough: Double)

/** What a .vox file holds, before it is put together.
  *
  * @param nodes     by their id; empty in files without a scene graph
  * @param palette   0xRRGGBB by colour index
  * @param materials by colour index
  * @param frames    of animations, after the first, that were not read
  * @param unknown   kinds of chunks that are not known, as often as they occur
  */
final case class VoxContent(
    models: IndexedSeq[VoxModel] = IndexedSeq.empty,
    nodes: Map[Int, VoxNode] = Map.empty,
    hiddenLayers: Set[Int] = Set.empty,
    palette: IndexedSeq[Int] = VoxContent.DefaultPalette,
    materials: Map[Int, VoxMaterial] = Map.empty,
    frames: Int = 0,
    unknown: Seq[String] = Nil
)

object VoxContent {

  /** The format's palette for files without one: steps of 51 from white to black, then ramps of red, green, blue and
    * grey.
    */
  val DefaultPalette: IndexedSeq[Int] = {
    val cube =
      for (r <- 255 to 0 by -51; g <- 255 to 0 by -51; b <- 255 to 0 by -51) yield r << 16 | g << 8 | b
    val ramp = Seq(0xee, 0xdd, 0xbb, 0xaa, 0x88, 0x77, 0x55, 0x44, 0x22, 0x11)
    val ramps = ramp.map(_ << 16) ++ ramp.map(_ << 8) ++ ramp ++ ramp.map(_ * 0x010101)
    (0 +: (cube.init ++ ramps)).toIndexedSeq
  }
}
