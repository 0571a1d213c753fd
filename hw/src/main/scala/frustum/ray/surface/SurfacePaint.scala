package frustum.ray.surface

import frustum.arithmetic.LockstepPipeline
import frustum.contract.ray.{RayChecker, RayImage, RayScene, RaySolid}
import frustum.ray.hit.WallStage
import spinal.core._
import spinal.lib._

/** Colour of the wall or quad that is hit, at the pipeline's last node; 0 where none is. */
class SurfacePaint(scene: RayScene, line: LockstepPipeline, walls: WallStage, cells: SurfaceCells)
    extends Area {
  private val surfaces = Surface.all(scene).zipWithIndex
  private val (before, last) = (line.nodes(line.nodes.size - 2), line.nodes.last)
  private val bits = cells.bits.map(b => if (b.getWidth == 0) b else last(before.insert(b)))

  private def shown(index: Int): Bool = last(walls.SURFACE)(index)
  private def channels(red: Bool, green: Bool, blue: Bool) =
    Seq(red, green, blue).flatMap(Seq.fill(8)(_)).reverse.asBits()
  private def where(shown: Bool, color: Bits): Bits = color & B(24 bits, default -> shown)

  /** Red, green, blue by the lowest bit of the cell along x, y, z. */
  private val checker = {
    val walls = surfaces.collect { case (Surface(w, None, RayChecker(cellBits), _, _), i) =>
      (w, cellBits, i)
    }
    val odd = (0 to 2).map { a =>
      walls.map { case (w, cellBits, i) =>
        val j = w.across.indexOf(a)
        shown(i) && (if (j < 0) Bool(w.bit(scene.room, cellBits)) else bits(j).lsb)
      }.foldLeft(False)(_ || _)
    }
    channels(odd(0), odd(1), odd(2))
  }
  private val solids = surfaces.collect { case (Surface(_, _, RaySolid(color), _, _), i) =>
    where(shown(i), B(color, 24 bits))
  }
  private val images = surfaces.collect { case (s @ Surface(_, _, image: RayImage, _, _), i) =>
    (s, image, i)
  }
    .groupBy(_._2).toSeq.sortBy(_._2.head._3).map { case (image, on) =>
      val words = for (row <- 0 until image.height; column <- 0 until image.width)
        yield B(image.texel(column, row), 24 bits)
      def at(column: Int) =
        (cells.bits(1 - column) resize image.rowBits) ## (cells.bits(column) resize image.columnBits)
      val turned = on.filter(_._1.wall.column == 1)
      val address =
        if (turned.isEmpty) at(0)
        else if (turned.size == on.size) at(1)
        else Mux(turned.map { case (_, _, i) => before(walls.SURFACE)(i) }.reduce(_ || _), at(1), at(0))
      val texel = if (words.size == 1) words.head else Mem(Bits(24 bits), words).readSync(address.asUInt)
      where(on.map { case (_, _, i) => shown(i) }.reduce(_ || _), texel)
    }
  val color: Bits = (solids ++ images).foldLeft(checker)(_ | _)
}
