package frustum.model.raster

import frustum.contract.raster.{FramePass, PackedTriangle, RasterConfig}
import frustum.model.raster.link.TriangleBox

/** The triangles of a pass that the set-up leaves out, because they face away or have no area: those whose boxes reach
  * into the pass's region are counted, each once, see [[frustum.raster.link.LinkStatus]].
  */
object UndrawnTriangles {
  def apply(config: RasterConfig, pass: FramePass): Seq[PackedTriangle] = pass.triangles.filter { t =>
    area(pass, t) <= 0 && reaches(config, pass, t)
  }

  /** Twice the area, in 1/256 pixel^2; negative where the triangle faces away. */
  def area(pass: FramePass, t: PackedTriangle): Long = {
    val Seq(a, b, c) = Seq(t.v0, t.v1, t.v2).map(pass.vertices)
    (b.x - a.x).toLong * (c.y - a.y) - (c.x - a.x).toLong * (b.y - a.y)
  }

  private def reaches(config: RasterConfig, pass: FramePass, t: PackedTriangle): Boolean = {
    val v = Seq(t.v0, t.v1, t.v2).map(pass.vertices)
    TriangleBox(config, v.map(_.x), v.map(_.y)).exists { box =>
      box.x0 <= pass.region.x1 && box.x1 >= pass.region.x0 && box.y0 <= pass.region.y1 && box.y1 >= pass.region.y0
    }
  }
}
