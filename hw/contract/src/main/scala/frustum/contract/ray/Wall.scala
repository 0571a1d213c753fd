package frustum.contract.ray

/** A wall of a [[RayRoom]]: `sign` is the end of `axis`. Where walls meet, the first in [[Wall.all]] is taken. */
case class Wall(index: Int, axis: Int, sign: Int) {

  /** The axes in its plane. */
  val across: Seq[Int] = (0 to 2).filter(_ != axis)

  /** Those of an image's columns, to the right, and of its rows, upwards: places in `across`. */
  val (column, row) = if (axis == 0) (1, 0) else (0, 1)

  def position(room: RayRoom): Int = if (sign > 0) room.high(axis) else room.low(axis)

  /** The checker bit of its own axis, the same all over the wall. */
  def bit(room: RayRoom, cellBits: Int): Boolean = ((position(room) - room.low(axis)) >> cellBits & 1) == 1
}

object Wall {
  val all: Seq[Wall] = Seq(Wall(0, 0, -1), Wall(1, 0, 1), Wall(2, 1, -1), Wall(3, 1, 1), Wall(4, 2, 1))
  val back: Wall = all.last

  /** Walls that meet in an edge, the one that is taken there first. */
  def pairs: Seq[(Wall, Wall)] =
    for (p <- all; q <- all if p.index < q.index && p.axis != q.axis) yield (p, q)
}
