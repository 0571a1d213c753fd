package frustum.driver.scene

/** A picture to be used as a texture.
  *
  * @param argb
  *   0xAARRGGBB, row by row from the TOP, as in picture files (texture coordinate t runs the other way)
  * @param hasAlpha
  *   false when every texel is opaque; decides between RGB565 and RGBA4444 in texel memory
  */
final case class TextureImage(width: Int, height: Int, argb: IndexedSeq[Int], hasAlpha: Boolean) {
  require(argb.length == width * height, s"${argb.length} texels for a texture of $width x $height")

  /** Kept, because pictures serve as keys. */
  override lazy val hashCode: Int = (width, height, argb, hasAlpha).##
}

object TextureImage {

  /** Sides the hardware takes, in texels. */
  val Sides: Seq[Int] = Seq(8, 16, 32, 64, 128)

  /** What is wrong with a size and what to do about it, or None. */
  def fault(width: Int, height: Int): Option[String] =
    Option.unless(Sides.contains(width) && Sides.contains(height))(
      s"is $width x $height texels; each side must be ${Sides.mkString(", ")} " +
        "(not necessarily square): scale the picture"
    )
}
