package frustum.scene

import frustum.driver.scene.TextureImage
import frustum.files.Notices
import java.nio.file.Path

/** The picture of a material.
  *
  * @param colored false where it has the opacity alone
  */
final case class MaterialPicture(image: TextureImage, colored: Boolean)

/** The pictures of materials, read once each, at sizes that the hardware holds together. What is missing, or of a
  * format that is not known, gets a notice and no picture.
  *
  * @param texels   of the texel memory
  * @param wanted   side for pictures of sizes that the hardware does not take, see [[TextureSizes]]
  * @param replaced a picture for all materials in place of their own
  */
final class MaterialPictures(texels: Int, wanted: Option[Int], replaced: Option[Path], notices: Notices) {
  import MaterialPictures.Source

  /** Picture of each material that has one. InputError for what is damaged. */
  def read(materials: Seq[Option[MtlMaterial]]): Map[Option[MtlMaterial], MaterialPicture] = {
    val forAll = replaced.map(Source(_, None, onlyAlpha = false, None))
    val sources = materials.distinct.flatMap(m => forAll.orElse(m.flatMap(source)).map(m -> _))
    def key(s: Source) = s.copy(namedBy = None)
    val each = sources.map(_._2).distinctBy(key)
    val sizes = each.map(s => TextureFile.size(s.file, s.namedBy))
    val images = each.zip(sizes).zip(TextureSizes(sizes, texels, wanted)).map { case ((source, (w, h)), held) =>
      if ((w, h) != held) {
        val remedy = if (wanted.isDefined) "scale the picture" else "--texture-size N asks for another size"
        notices.at(
          source.namedBy.fold(source.file.toString)(_.place),
          s"${source.file.getFileName} of $w x $h texels is resampled to ${held._1} x ${held._2}; $remedy",
          s"resampled ${key(source)}"
        )
      }
      key(source) -> image(source, held)
    }.toMap
    sources.map { case (m, source) => m -> MaterialPicture(images(key(source)), !source.onlyAlpha) }.toMap
  }

  private def source(m: MtlMaterial): Option[Source] = {
    val map = m.map.flatMap(s => find(s).map(s -> _))
    val alpha = m.alphaMap.flatMap(s => find(s).map(s -> _))
    for ((a, file) <- alpha; (c, _) <- map if (a.scale, a.offset, a.clamp) != (c.scale, c.offset, c.clamp))
      notices.at(
        a.line.place,
        s"$file lies on the surface as the picture of map_Kd does; give both the same options",
        s"map_d $file"
      )
    (map, alpha) match {
      case (Some((s, file)), None) => Some(Source(file, None, onlyAlpha = false, Some(s.line)))
      case (Some((s, file)), Some((a, alphaFile))) if file == alphaFile =>
        // its own opacity is what is meant; its brightness would make holes of dark colours
        Some(Source(
          file,
          a.channel.filterNot(_ == 'm').map(c => alphaFile -> Some(c)),
          onlyAlpha = false,
          Some(s.line)
        ))
      case (Some((s, file)), Some((a, alphaFile))) =>
        Some(Source(file, Some(alphaFile -> a.channel), onlyAlpha = false, Some(s.line)))
      case (None, Some((a, alphaFile))) =>
        Some(Source(alphaFile, Some(alphaFile -> a.channel), onlyAlpha = true, Some(a.line)))
      case (None, None) => None
    }
  }

  private def find(statement: MapStatement): Option[Path] = {
    val line = statement.line
    def missing(what: String) =
      notices.at(line.place, s"$what: the plain colour is shown instead", s"picture ${statement.name}")
    NamedFile.find(line, statement.name) match {
      case None                                          => missing(s"there is no picture '${statement.name}'"); None
      case Some(found) if !TextureFile.known(found.path) =>
        missing(s"${found.path}: is not a picture in a known format; save it as PNG")
        None
      case Some(found) =>
        if (!found.asWritten)
          notices.at(
            line.place,
            s"there is no picture '${statement.name}'; ${found.path} is taken for it",
            s"picture ${statement.name}"
          )
        Some(found.path)
    }
  }

  private def image(source: Source, size: (Int, Int)): TextureImage = {
    def opacity = source.alpha.map { case (file, channel) =>
      val hasAlpha = TextureFile.resampled(file, source.namedBy, size).hasAlpha
      TextureFile.resampled(file, source.namedBy, size, MaterialPictures.opacity(_, channel, hasAlpha))
    }
    if (source.onlyAlpha) opacity.get
    else {
      val colors = TextureFile.resampled(source.file, source.namedBy, size)
      opacity.fold(colors) { alpha =>
        val argb = colors.argb.zip(alpha.argb).map { case (c, a) => a & 0xff000000 | c & 0xffffff }
        TextureImage(colors.width, colors.height, argb, alpha.hasAlpha)
      }
    }
  }
}

object MaterialPictures {

  /** Where a texel's colour and opacity come from, and who says so.
    *
    * @param alpha     a file, and the channel of it that is named
    * @param onlyAlpha the colour is white
    */
  private final case class Source(
      file: Path,
      alpha: Option[(Path, Option[Char])],
      onlyAlpha: Boolean,
      namedBy: Option[SourceLine]
  )

  /** White of the opacity that a texel of `map_d` stands for: the channel that `-imfchan` names, else its alpha
    * where the picture has some, else its luminance.
    */
  private def opacity(argb: Int, channel: Option[Char], hasAlpha: Boolean): Int = {
    val (r, g, b) = (argb >> 16 & 255, argb >> 8 & 255, argb & 255)
    def luminance = (299 * r + 587 * g + 114 * b + 500) / 1000
    val level = channel match {
      case Some('r')        => r
      case Some('g')        => g
      case Some('b')        => b
      case Some('m')        => argb >>> 24
      case None if hasAlpha => argb >>> 24
      case _                => luminance
    }
    level << 24 | 0xffffff
  }
}
