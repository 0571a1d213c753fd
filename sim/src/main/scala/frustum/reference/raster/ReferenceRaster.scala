package frustum.reference.raster

import frustum.contract.raster.{FramePass, RenderState, TextureUpload}
import frustum.driver.raster.PreparedFrame

/** A covered pixel of the reference. `texel` is after wrapping, None without a texture; `drawn` when it passed the
  * tests of its alpha and depth.
  */
final case class ReferenceFragment(
    triangle: Int,
    x: Int,
    y: Int,
    at: Attributes,
    texel: Option[(Int, Int)],
    state: RenderState,
    drawn: Boolean
)

/** Draws frames in float64 from the textbook: homogeneous coordinates, perspective-exact texture coordinates,
  * top-left rule, pixel centres at +0.5. It shares no arithmetic with the hardware or its model.
  */
object ReferenceRaster {
  type Watch = ReferenceFragment => Unit
  private val ignore: Watch = _ => ()

  /** Texel memory after the uploads; texels that nobody wrote are 0. */
  def texelMemory(uploads: Seq[TextureUpload]): Array[Int] = {
    val memory = new Array[Int](32768)
    uploads.foreach(u => u.texels.copyToArray(memory, u.base * 64))
    memory
  }

  /** Draws the passes with the vertices as the hardware decodes them: positions snapped to 1/16 pixel. */
  def draw(frame: PreparedFrame, watch: Watch = ignore): ReferenceFrame = {
    val target = new ReferenceFrame(frame.config)
    val memory = texelMemory(frame.textures)
    frame.passes.foldLeft(0) { (first, pass) =>
      drawPass(target, pass, memory, first, watch)
      first + pass.triangles.length
    }
    target
  }

  /** Draws one pass into `target`; its triangles are numbered from `first`. */
  def drawPass(
      target: ReferenceFrame,
      pass: FramePass,
      memory: Array[Int],
      first: Int,
      watch: Watch
  ): Unit = {
    val rect = PixelRect.of(pass.region, target.config)
    target.clear(rect, Sampler.rgb565(pass.clearColor))
    for ((triangle, index) <- pass.triangles.zipWithIndex) {
      val corners = IndexedSeq(triangle.v0, triangle.v1, triangle.v2).map(pass.vertices)
      drawTriangle(
        target,
        rect,
        first + index,
        ExactCoverage.of(corners),
        corners.map(ScreenVertex.of),
        pass.states(triangle.state),
        memory,
        watch
      )
    }
  }

  /** Draws the frame from the vertices before they were quantised: nothing is snapped or rounded but the
    * texels.
    */
  def drawEndToEnd(frame: PreparedFrame, watch: Watch = ignore): ReferenceFrame = {
    val target = new ReferenceFrame(frame.config)
    val memory = texelMemory(frame.textures)
    val screen = PixelRect.screen(frame.config)
    frame.passes.headOption.foreach(p => target.clear(screen, Sampler.rgb565(p.clearColor)))
    for ((triangle, index) <- frame.clipTriangles.zipWithIndex) {
      val corners = triangle.v.map(ScreenVertex.of(_, frame.config))
      drawTriangle(target, screen, index, new FloatCoverage(corners), corners, triangle.state, memory, watch)
    }
    target
  }

  private def drawTriangle(
      target: ReferenceFrame,
      rect: PixelRect,
      index: Int,
      coverage: Coverage,
      corners: IndexedSeq[ScreenVertex],
      state: RenderState,
      memory: Array[Int],
      watch: Watch
  ): Unit = {
    val attributes = new TriangleAttributes(corners)
    coverage.foreach(rect) { (x, y) =>
      val at = attributes(x, y)
      val texel = Shading.texelOf(state, at)
      val drawn = target.write(index, x, y, at.z, Shading.color(state, memory, at, texel), state)
      watch(ReferenceFragment(index, x, y, at, texel, state, drawn))
    }
  }
}
