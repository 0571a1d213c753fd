package frustum.scene

import frustum.contract.InputError
import frustum.contract.voxel.{BlockTable, BlockType, VoxelAssets, VoxelTextures}
import frustum.demos.voxel.BlockArt
import frustum.files.JsonFile
import java.nio.file.Path
import scala.collection.mutable

/** A table of blocks as JSON: a list, the first with id 1, of
  * `{"name": "grass", "top": "grass", "bottom": "dirt", "side": "grass side", "opaque": true, "selectable": true, "joins": false}`.
  * `"texture"` stands for all faces not named; the flags may be left out (true, true, false). A texture is one of the
  * workbench's by its name or a PNG file of 16 x 16, beside the JSON file, with at most 16 colours.
  */
object BlockFile {
  private val Keys = Seq("name", "texture", "top", "bottom", "side", "opaque", "selectable", "joins")

  def read(file: Path): VoxelAssets = {
    def refuse(what: String): Nothing = throw InputError(s"$file: $what")
    val root = JsonFile.read(file, "docs/voxel.md")
    val textures = mutable.LinkedHashMap.empty[String, (IndexedSeq[Int], IndexedSeq[Int])]

    def block(v: ujson.Value, i: Int): BlockType = {
      val where = s"block ${i + 1}"
      val fields = v match {
        case o: ujson.Obj => o.value
        case _            => refuse(s"$where: is no object; write {\"name\": ...}")
      }
      fields.keys.find(!Keys.contains(_)).foreach(k =>
        refuse(s"$where: there is no key '$k'; known are ${Keys.mkString(", ")}")
      )
      def text(key: String) = fields.get(key).map(_.strOpt.getOrElse(refuse(s"$where: $key is no string")))
      def flag(key: String, default: Boolean) =
        fields.get(key).fold(default)(_.boolOpt.getOrElse(refuse(s"$where: $key is neither true nor false")))
      def texture(key: String) = {
        val name =
          text(key).orElse(text("texture")).getOrElse(refuse(s"$where: has neither $key nor texture"))
        textures.getOrElseUpdate(name, load(name, where))
        textures.keys.toSeq.indexOf(name)
      }
      val Seq(side, top, bottom) = Seq("side", "top", "bottom").map(texture)
      BlockType(
        text("name").getOrElse(refuse(s"$where: has no name")),
        Seq(side, side, side, side, bottom, top),
        flag("opaque", default = true),
        flag("selectable", default = true),
        flag("joins", default = false)
      )
    }

    def load(name: String, where: String): (IndexedSeq[Int], IndexedSeq[Int]) =
      if (name.toLowerCase.endsWith(".png")) picture(file.resolveSibling(name), where)
      else BlockArt.names.indexOf(name) match {
        case -1 => refuse(
            s"$where: there is no texture '$name'; give a PNG file or one of ${BlockArt.names.mkString(", ")}"
          )
        case i => (BlockArt.textures.indices(i), BlockArt.textures.palettes(i))
      }

    def picture(png: Path, where: String): (IndexedSeq[Int], IndexedSeq[Int]) = {
      val side = VoxelTextures.Side
      val image =
        try TextureFile.read(
            png,
            fault = (width, height) =>
              Option.unless(width == side && height == side)(
                s"is $width x $height texels; a block's has $side x $side: scale the picture"
              )
          )
        catch { case InputError(message) => refuse(s"$where: $message") }
      val texels = image.argb.map { argb =>
        def four(at: Int) = ((argb >> at & 255) * 15 + 127) / 255
        four(16) << 12 | four(8) << 8 | four(0) << 4 | four(24)
      }
      val palette = texels.distinct
      if (palette.length > VoxelTextures.Colors)
        refuse(
          s"$where: $png: has ${palette.length} colours at four bits a channel; reduce them to ${VoxelTextures.Colors}"
        )
      (texels.map(palette.indexOf(_)), palette.padTo(VoxelTextures.Colors, 0))
    }

    val blocks = root match {
      case list: ujson.Arr => list.value.zipWithIndex.map { case (v, i) => block(v, i) }.toIndexedSeq
      case _               => refuse("is no list; write [{...}, ...]")
    }
    if (blocks.length > BlockTable.Most) refuse(s"has ${blocks.length} blocks; at most ${BlockTable.Most}")
    if (textures.size > VoxelTextures.Most)
      refuse(s"names ${textures.size} textures; at most ${VoxelTextures.Most}")
    try VoxelAssets(
        BlockTable(blocks),
        VoxelTextures(textures.values.map(_._1).toIndexedSeq, textures.values.map(_._2).toIndexedSeq)
      )
    catch { case e: IllegalArgumentException => refuse(e.getMessage.stripPrefix("requirement failed: ")) }
  }
}
