package frustum.driver.raster

import frustum.contract.InputError
import frustum.contract.raster.{FramePass, PackedTriangle, PackedVertex, RasterConfig, TextureUpload, VertexRanges}
import frustum.driver.linear.Matrix4
import frustum.driver.scene.{Camera, Scene}
import scala.collection.mutable

/** From a scene to what the hardware draws: matrices, light, clipping, culling, packing, passes, wire
  * commands.
  *
  * {{{
  *   val scene    = Scenes.byName("teapot")
  *   val options  = DrawOptions(light = None, cullBack = false, Wrap.Repeat, background = 0x000000)
  *   val prepared = Driver.prepare(scene, scene.camera, options, RasterConfig(), frame = 0)
  *   prepared.textures.flatMap(Driver.commands).foreach(transport.send)
  *   prepared.passes.flatMap(Driver.commands).foreach(transport.send)
  * }}}
  */
object Driver {

  /** Everything a frame needs. Opaque triangles keep the scene's order, blended ones follow from back to
    * front by the depth of their centroid. Triangles without area, wholly outside, or away from the viewer
    * (`cullBack`) are dropped; where both sides are drawn two vertices change places, because the hardware
    * draws one direction only.
    *
    * Pass i of n in frame f has the number f n + i, so that successive passes never share one.
    *
    * InputError for what cannot be drawn: camera, light, textures, number of states, depth range,
    * repeats, full store.
    */
  def prepare(
      scene: Scene,
      camera: Camera,
      options: DrawOptions,
      config: RasterConfig,
      frame: Int
  ): PreparedFrame = {
    options.light.foreach(Lambert.check)
    val textures = TextureMemory.allocate(scene, config)
    val states = StateTable(scene, textures, options)
    for (state <- states.states; fault <- config.fixed.fault(state))
      throw InputError(
        s"${scene.place}: $fault, which this hardware was made without; build it for the scene (./sbt fit)"
      )
    val clear = TextureMemory.rgb565(options.background)
    for (only <- config.clearColor if only != clear)
      throw InputError(
        f"${scene.place}: the background is $clear%04x in RGB565, this hardware clears to $only%04x alone; " +
          "build it for the scene (./sbt fit)"
      )
    val clipped = clipTriangles(scene, camera, options, config, states)
    val scaled = scaleW(clipped)
    val viewport = new Viewport(config)
    val (left, drawn) = scaled.partitionMap(t => place(t, states.states.indexOf(t.state), options.cullBack, viewport))
    val regions = new PassSplitter(config, states.states, scene.place).split(drawn.map(_._2))
    val passes = regions.zipWithIndex.map { case ((region, triangles), i) =>
      val (vertices, indexed) = share(triangles)
      val number = (frame * regions.length + i) & 0xffff
      FramePass(number, clear, region, states.states, vertices, indexed)
    }
    PreparedFrame(
      config,
      textures.uploads,
      passes,
      drawn.map(_._1),
      scene.triangles.length,
      drawn.length,
      regions.map(_._2.map(_.source)),
      left.foldLeft(LeftOut())(_ + _)
    )
  }

  /** The bytes of each wire command of a pass, in the order to send them. */
  def commands(pass: FramePass): Seq[Seq[Int]] = CommandEncoder.pass(pass)

  /** The bytes of each wire command of a texture. */
  def commands(upload: TextureUpload): Seq[Seq[Int]] = CommandEncoder.upload(upload)

  /** The model's turn in the world. */
  private[raster] def turnOf(scene: Scene, options: DrawOptions): Matrix4 = {
    val centre = scene.boundingSphere._1
    Matrix4.translation(centre) * Matrix4.rotationY(scala.math.toRadians(options.turnDegrees)) *
      Matrix4.translation(-centre)
  }

  private def clipTriangles(
      scene: Scene,
      camera: Camera,
      options: DrawOptions,
      config: RasterConfig,
      states: StateTable
  ): IndexedSeq[ClipTriangle] = {
    val turn = turnOf(scene, options)
    val toClip = Projection(camera, config.width.toDouble / config.height) * turn
    val shader = new VertexShader(toClip, turn, options.light)
    val clipper = new Clipper(config)
    val shaded = scene.triangles.zipWithIndex.map { case (t, i) =>
      val material = scene.materials(t.material)
      (material.blend, ClipTriangle(t.vertices.map(shader(_, material)).toIndexedSeq, states(t.material), i))
    }
    val (blended, opaque) = shaded.partition(_._1)
    val backToFront = blended.map(_._2).sortBy(t => -depth(t, camera))
    (opaque.map(_._2) ++ backToFront).flatMap { t =>
      val polygon = clipper.clip(t.v)
      (1 until polygon.length - 1)
        .map(i => t.copy(v = IndexedSeq(polygon(0), polygon(i), polygon(i + 1))))
        .flatMap(withinRepeats(scene, _))
    }
  }

  /** Cut where it has more repeats than the vertex format holds; without a texture its coordinates mean nothing: zero
    * lets vertices be shared.
    */
  private def withinRepeats(scene: Scene, t: ClipTriangle): Seq[ClipTriangle] =
    if (t.state.texture.isEmpty) Seq(t.copy(v = t.v.map(_.copy(s = 0, t = 0))))
    else {
      RepeatRemoval.fault(t).foreach(fault => throw InputError(s"${scene.place(t.source)}: $fault"))
      RepeatRemoval.parts(t)
    }

  /** Distance of the centroid along the line of sight: w in a perspective view, z in an orthographic one. */
  private def depth(t: ClipTriangle, camera: Camera): Double =
    t.v.map(v => if (camera.orthoHeight.isDefined) v.clip.z else v.clip.w).sum

  private def scaleW(triangles: IndexedSeq[ClipTriangle]): IndexedSeq[ClipTriangle] = {
    val w = triangles.iterator.flatMap(_.v).map(_.clip.w).toSeq
    val scale = if (w.isEmpty) 1.0 else WScale.factor(w.min, w.max)
    if (scale == 1) triangles
    else triangles.map(t => t.copy(v = t.v.map(v => v.copy(clip = v.clip * scale))))
  }

  /** Snaps a triangle to the screen and turns it clockwise, or tells why it is not to be drawn. Its front is seen where
    * it turns counter-clockwise in window coordinates, whose y points upwards (OpenGL 2.1, 3.5.1): on the screen, whose
    * y points downwards, the area is negative there.
    */
  private def place(
      t: ClipTriangle,
      state: Int,
      cullBack: Boolean,
      viewport: Viewport
  ): Either[LeftOut, (ClipTriangle, PackedCorners)] = {
    def corners(t: ClipTriangle, offset: (Int, Int)) = t.v.map(viewport.pack(_, offset))
    val snapped = corners(t, (0, 0))
    val area = viewport.area(snapped(0), snapped(1), snapped(2))
    val turned = if (area < 0) t.copy(v = IndexedSeq(t.v(0), t.v(2), t.v(1))) else t
    for {
      _ <- Either.cond(area != 0, (), LeftOut(withoutArea = 1))
      _ <- Either.cond(area < 0 || !cullBack, (), LeftOut(facingAway = 1))
      pixels <- viewport.pixels(snapped).toRight(LeftOut(withoutPixel = 1))
    } yield {
      val p = corners(turned, RepeatRemoval.offset(turned))
      p.flatMap(_.fault)
        .headOption
        .foreach(fault => throw new IllegalStateException(s"driver: a vertex's $fault"))
      reaches(turned, p, viewport.ranges).foreach(fault =>
        throw InputError(
          s"a triangle: $fault, beyond what this hardware was made for; build it for the scene (./sbt fit)"
        )
      )
      (turned, PackedCorners(state, p(0), p(1), p(2), pixels, t.source, back = area > 0))
    }
  }

  /** How a triangle goes beyond the ranges of hardware made for less. */
  private def reaches(t: ClipTriangle, corners: Seq[PackedVertex], ranges: VertexRanges): Option[String] = {
    val w = t.v.map(_.clip.w)
    corners.flatMap(_.fault(ranges)).headOption.orElse(Option.when(
      t.state.texture.isDefined && ranges.ratio < VertexRanges().ratio && w.max > w.min * (1 << ranges.ratio)
    )(s"depths of ${w.min} to ${w.max} in a triangle"))
  }

  /** Gives every distinct vertex an index, in the order of first use. */
  private def share(
      triangles: IndexedSeq[PackedCorners]
  ): (IndexedSeq[PackedVertex], IndexedSeq[PackedTriangle]) = {
    val index = mutable.LinkedHashMap.empty[PackedVertex, Int]
    def of(v: PackedVertex) = index.getOrElseUpdate(v, index.size)
    val indexed = triangles.map(t => PackedTriangle(t.state, of(t.v0), of(t.v1), of(t.v2)))
    (index.keys.toIndexedSeq, indexed)
  }
}
