package frustum.contract.raster

import frustum.contract.ValidFor

/** Ranges within which the methods of the rasterizer and its driver keep their error bounds. */
object RasterDomains {
  private val Wide = 1e6

  // raster: triangles as the hardware takes them
  val WRatio =
    ValidFor("perspective", "w-ratio", "within a triangle", 1, Domain.MaxWRatio, 1.0 / 16, "texels of 128")
  val Repeats = ValidFor(
    "perspective",
    "repeats",
    "across a triangle",
    1.0 / 16,
    Domain.MaxRepeats - 1.0 / 128,
    1.5,
    "texels of 128"
  )
  val Area =
    ValidFor("planes", "area", "1/512 square pixel", Domain.MinArea, 1 << 20, 32, "depth units of 65,536")
  val TriangleSize =
    ValidFor("planes", "triangle-size", "pixels", 1, 2046, 1.0 / 256, "depth units of 65,536")
  val SliverWidth = ValidFor("coverage", "sliver-width", "1/16 pixel", 1, 1024, 0, "pixels")
  val TJunction =
    ValidFor("coverage", "t-junction", "1/16 pixel off the edge", 0, 0, 0, "pixels missed or drawn twice")
  val ScreenSide = ValidFor("coverage", "screen-side", "pixels", 8, 512, 0, "pixels")

  // raster: scenes as the driver takes them
  val SceneScale =
    ValidFor("driver", "scene-scale", "times the floor from 1 to 100", 1 / Wide, Wide, 0.5, "% of texels")
  val FarOverNear = ValidFor(
    "driver",
    "far-over-near",
    "of a floor in two triangles",
    1.01,
    Domain.MaxWRatio,
    0.5,
    "% of texels"
  )
  val LateRatio = ValidFor(
    "perspective",
    "w-ratio-late",
    "of a floor in two triangles, hardware for no more",
    1.01,
    1 << VertexRanges.LateRatio,
    0.5,
    "% of texels"
  )
  val NearPlane = ValidFor(
    "driver",
    "near-plane",
    "of the far plane, a floor through it",
    1.0 / Domain.MaxWRatio,
    0.5,
    0.5,
    "% of texels"
  )
  val EyeHeight =
    ValidFor("driver", "eye-height", "over a floor from 1 to 100", 1.0 / 32, 64, 0.5, "% of texels")
  val Overhang = ValidFor("driver", "overhang", "screens beyond the border", 1, Wide, 0.5, "% of pixels")
  val Clamped =
    ValidFor("texture", "clamped-coordinate", "repeats beyond 0 and 1", 1, 126, 0.5, "% of texels")
  val TextureSide = ValidFor("texture", "texture-side", "log2 texels", 3, 7, 0.5, "% of texels")
  val DepthGap = ValidFor("depth", "depth-gap", "of the depth, far = 100 near", 0.005, 1, 0, "% of pixels")
  val OrthoDepth = ValidFor("depth", "orthographic-range", "world units", 1 / Wide, Wide, 0, "% of pixels")

  // units that every fragment goes through: whole ranges of their inputs
  val VertexColor = ValidFor("combine", "vertex-colour", "0..255", 0, 255, 0.61, "levels of the frame buffer")
  val SourceAlpha = ValidFor("blend", "source-alpha", "of 31", 0, 31, 1.3, "levels of the frame buffer")
}
