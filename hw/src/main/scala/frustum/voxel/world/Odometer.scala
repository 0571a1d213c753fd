package frustum.voxel.world

import spinal.core._

/** Counts through a box from (0, 0, 0), the last axis fastest, to `ends`. */
class Odometer(ends: Seq[Int]) extends Area {
  val at = Vec(ends.map(n => Reg(UInt(log2Up(n + 1) bits)) init 0))
  val full = ends.zip(at).map { case (n, a) => a === n }

  /** The place is the last one; the next step returns to the first. */
  val over = full.reduce(_ && _)

  def step(): Unit = for (k <- ends.indices) when(full.drop(k + 1).fold(True)(_ && _)) {
    at(k) := at(k) + 1
    when(full(k))(at(k) := 0)
  }
  def clear(): Unit = at.foreach(_ := 0)
}
