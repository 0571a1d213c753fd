package frustum.scene

import frustum.contract.InputError
import frustum.contract.voxel.{BlockTable, BlockType, VoxelAssets, VoxelTextures}
import frustum.demos.voxel.BlockArt
import frustum.files.{JsonDocument, JsonFile}
import java.nio.file.Path
import scala.collection.mutable

/** A table of blocks as JSON: a list, the first with id 1, of `{"name": "grass", "top": "grass", "bottom": "dirt",
  * "side": "grass side", "opaque": true, "selectable": true, "joins": false}`. `"texture"` stands for all faces not
  * named; the flags may be left out (true, true, false). A texture is one of the workbench's by its name or a PNG file
  * of 16 x 16, beside the JSON file, with at most 16 colours.
  */
object BlockFile {
  private val Keys = Seq("name", "texture", "top", "bottom", "side", "opaque", "selectable", "joins")

  def read(file: Path): VoxelAssets = new Reader(JsonFile.read(file, "docs/voxel.md")).assets

  private class Reader(document: JsonDocument) extends JsonFields(document) {
    private val textures = mutable.LinkedHashMap.empty[String, (IndexedSeq[Int], IndexedSeq[Int])]

    override protected def named(path: String): String =
      path.replaceFirst("^\\[(\\d+)].*", "$1").toIntOption.fold("the list")(i => s"block ${i + 1}")

    private def block(v: ujson.Value, path: String): BlockType = {
      val o = fields(v, path, Keys: _*)
      def text(key: String) =
        o.get(key).map(_.strOpt.getOrElse(refuse(inside(path, key), s"$key is no string")))
      def flag(key: String, default: Boolean) =
        o.get(key).fold(default)(_.boolOpt.getOrElse(refuse(inside(path, key), s"$key is neither true nor false")))
      def texture(key: String) = {
        val from = if (o.contains(key)) key else "texture"
        val name = text(from).getOrElse(refuse(path, s"has neither $key nor texture"))
        textures.getOrElseUpdate(name, load(name, inside(path, from)))
        textures.keys.toSeq.indexOf(name)
      }
      val Seq(side, top, bottom) = Seq("side", "top", "bottom").map(texture)
      BlockType(
        text("name").getOrElse(refuse(path, "has no name")),
        Seq(side, side, side, side, bottom, top),
        flag("opaque", default = true),
        flag("selectable", default = true),
        flag("joins", default = false)
      )
    }

    private def load(name: String, path: String): (IndexedSeq[Int], IndexedSeq[Int]) =
      if (name.toLowerCase.endsWith(".png")) picture(document.file.resolveSibling(name), path)
      else BlockArt.names.indexOf(name) match {
        case -1 => refuse(
            path,
            s"there is no texture '$name'; give a PNG file or one of ${BlockArt.names.mkString(", ")}"
          )
        case i => (BlockArt.textures.indices(i), BlockArt.textures.palettes(i))
      }

    private def picture(png: Path, path: String): (IndexedSeq[Int], IndexedSeq[Int]) = {
      val side = VoxelTextures.Side
      val image =
        try TextureFile.read(
            png,
            fault = (width, height) =>
              Option.unless(width == side && height == side)(
                s"is $width x $height texels; a block's has $side x $side: scale the picture"
              )
          )
        catch { case InputError(message) => refuse(path, message) }
      val texels = image.argb.map { argb =>
        def four(at: Int) = ((argb >> at & 255) * 15 + 127) / 255
        four(16) << 12 | four(8) << 8 | four(0) << 4 | four(24)
      }
      val palette = texels.distinct
      if (palette.length > VoxelTextures.Colors)
        refuse(
          path,
          s"$png: has ${palette.length} colours at four bits a channel; reduce them to ${VoxelTextures.Colors}"
        )
      (texels.map(palette.indexOf(_)), palette.padTo(VoxelTextures.Colors, 0))
    }

    def assets: VoxelAssets = {
      val blocks = list(document.root, "").zipWithIndex.map { case (v, i) => block(v, s"[$i]") }.toIndexedSeq
      if (blocks.isEmpty) refuse("", "has no blocks; write [{\"name\": ..., \"texture\": ...}, ...]")
      if (blocks.length > BlockTable.Most)
        refuse(s"[${BlockTable.Most}]", s"is one too many; at most ${BlockTable.Most}")
      if (textures.size > VoxelTextures.Most)
        refuse("", s"names ${textures.size} textures; at most ${VoxelTextures.Most}")
      val faces = VoxelTextures(textures.values.map(_._1).toIndexedSeq, textures.values.map(_._2).toIndexedSeq)
      for ((b, i) <- blocks.zipWithIndex if b.opaque; t <- b.textures.distinct)
        if (faces.indices(t).exists(texel => (faces.palettes(t)(texel) & 15) != 15)) refuse(
          s"[$i]",
          s"'${b.name}' is called opaque, but its texture '${textures.keys.toSeq(t)}' lets light through; " +
            "write \"opaque\": false"
        )
      VoxelAssets(BlockTable(blocks), faces)
    }
  }
}
