package frustum.model.ray

import frustum.contract.ray.{RayChecker, RayImage, RayPaint, RayRoom, RaySolid, Wall}

/** What a wall, or a quad on it, shows where it is hit. */
object SurfacePaint {

  /** 0xRRGGBB.
    *
    * @param places of the hit along the wall's axes, above the surface's low corner, times n
    */
  def apply(paint: RayPaint, w: Wall, room: RayRoom, places: Int => Long, n: Long): Int = {
    def cell(j: Int) = (places(j) / (n << paint.cellBits)).toInt
    paint match {
      case RaySolid(color)      => color
      case image: RayImage      => image.texel(cell(w.column), cell(w.row))
      case RayChecker(cellBits) =>
        (0 to 2).map { a =>
          val j = w.across.indexOf(a)
          if (if (j < 0) w.bit(room, cellBits) else (cell(j) & 1) == 1) 0xff0000 >> 8 * a else 0
        }.sum
    }
  }

  /** In the shadow. */
  def darkened(color: Int): Int = (color >> 1) & 0x7f7f7f
}
