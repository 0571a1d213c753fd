package frustum.driver.raster

import frustum.contract.InputError
import frustum.contract.raster.{RasterConfig, TexelFormat, TextureRef, TextureUpload}
import frustum.driver.scene.{Scene, TextureImage}

/** Where the textures of a scene lie in texel memory, and what to send there. */
final case class TextureMemory(references: Map[TextureImage, TextureRef], uploads: Seq[TextureUpload])

object TextureMemory {

  /** Texels between the addresses a texture may start at. */
  val Unit = 64

  /** One texture after the other, in the order of the materials that triangles use; InputError naming the
    * sizes when they do not fit.
    */
  def allocate(scene: Scene, config: RasterConfig): TextureMemory = {
    val used = scene.triangles.iterator.map(_.material).toSet
    val images = scene.materials.indices
      .filter(used)
      .flatMap(i => scene.materials(i).texture.map(scene.materials(i).name -> _))
    for ((material, image) <- images) TextureImage.fault(image.width, image.height).foreach { fault =>
      throw InputError(s"${scene.place}: the texture of material '$material' $fault")
    }
    val distinct = images.map(_._2).distinct
    val total = distinct.map(i => i.width * i.height).sum
    if (total > config.textureTexels)
      throw InputError(
        s"${scene.place}: textures of " + distinct.map(i => s"${i.width} x ${i.height}").mkString(", ") +
          s" need $total texels, the memory has ${config.textureTexels}; use smaller or fewer textures"
      )
    val bases = distinct.scanLeft(0)((base, image) => base + image.width * image.height / Unit)
    val references = distinct.zip(bases).map { case (image, base) =>
      image -> TextureRef(base, log2(image.width), log2(image.height), format(image))
    }
    TextureMemory(
      references.toMap,
      references.map { case (image, ref) => TextureUpload(ref.base, texels(image)) }
    )
  }

  def format(image: TextureImage): TexelFormat =
    if (image.hasAlpha) TexelFormat.Rgba4444 else TexelFormat.Rgb565

  /** The texels as the memory holds them: bottom row first, so that row = floor(t * height). */
  def texels(image: TextureImage): IndexedSeq[Int] = {
    val pack: Int => Int = if (image.hasAlpha) rgba4444 else rgb565
    image.argb.grouped(image.width).toIndexedSeq.reverse.flatten.map(pack)
  }

  /** 0x..RRGGBB to RGB565, each channel rounded to nearest. */
  def rgb565(argb: Int): Int = level(argb >> 16, 31) << 11 | level(argb >> 8, 63) << 5 | level(argb, 31)

  /** 0xAARRGGBB to RGBA4444, each channel rounded to nearest. */
  def rgba4444(argb: Int): Int =
    level(argb >> 16, 15) << 12 | level(argb >> 8, 15) << 8 | level(argb, 15) << 4 | level(argb >> 24, 15)

  private def level(byte: Int, most: Int): Int = ((byte & 255) * most + 127) / 255

  private def log2(n: Int) = Integer.numberOfTrailingZeros(n)
}
