package frustum.scene

import frustum.driver.scene.TextureImage

/** Sizes for the pictures of a scene that the hardware holds.
  *
  * A picture of a size that the hardware takes keeps it. The sides of any other become powers of two: those that
  * are one stay, the rest become the largest with which all pictures fit the texel memory, or what is asked for.
  * Where the memory is too small even so, pictures of any size shrink.
  */
object TextureSizes {

  /** @param sizes  width and height of each picture
    * @param texels of the memory
    * @param wanted side of pictures of other sizes; None: the largest that fits
    */
  def apply(sizes: Seq[(Int, Int)], texels: Int, wanted: Option[Int]): Seq[(Int, Int)] = {
    def side(most: Int)(size: Int) = if (TextureImage.Sides.contains(size)) size.min(most) else most
    def all(most: Int) = sizes.map { case (w, h) => (side(most)(w), side(most)(h)) }
    def others(most: Int) = sizes.zip(all(most)).map { case ((w, h), smaller) =>
      if (TextureImage.fault(w, h).isEmpty) (w, h) else smaller
    }
    def fits(them: Seq[(Int, Int)]) = them.map { case (w, h) => w * h }.sum <= texels
    val falling = TextureImage.Sides.reverse
    wanted.map(others).getOrElse((falling.map(others) ++ falling.map(all)).find(fits).getOrElse(others(falling.last)))
  }
}
