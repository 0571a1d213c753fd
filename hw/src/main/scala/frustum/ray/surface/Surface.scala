package frustum.ray.surface

import frustum.contract.ray.{RayPaint, RayScene, Wall}

/** A wall or a quad as it is painted.
  *
  * @param quad None for a wall
  * @param forms the hit's coordinates above the surface's low corner, times n
  * @param extents greatest coordinates
  */
case class Surface(wall: Wall, quad: Option[Int], paint: RayPaint, forms: Seq[String], extents: Seq[Int]) {

  /** Bits of the cell's number along coordinate j (0, 1) that the paint uses, and all bits that it may have. */
  def bits(j: Int): Int = if (j == wall.column) paint.columnBits else paint.rowBits
  def quotient(j: Int): Int = BigInt(extents(j) >> paint.cellBits).bitLength
}

object Surface {

  /** Walls, then quads. */
  def all(scene: RayScene): Seq[Surface] = {
    import scene.room
    Wall.all.map { w =>
      Surface(
        w,
        None,
        room.paints(w.index),
        w.across.map(u => s"across${w.index}_$u"),
        w.across.map(u => room.high(u) - room.low(u))
      )
    } ++ scene.quads.zipWithIndex.map { case (q, i) =>
      Surface(Wall.back, Some(i), q.paint, Wall.back.across.map(u => s"quad${i}_$u"), Seq.fill(2)(2 * q.half))
    }
  }
}
