package frustum.scene

/** A picture to be used as a texture.
  *
  * @param argb     0xAARRGGBB, row by row from the TOP, as in picture files (texture coordinate t runs the other way)
  * @param hasAlpha false when every texel is opaque; decides between RGB565 and RGBA4444 in texel memory
  */
final case class TextureImage(width: Int, height: Int, argb: IndexedSeq[Int], hasAlpha: Boolean) {
  require(argb.length == width * height, s"${argb.length} texels for a texture of $width x $height")
}
