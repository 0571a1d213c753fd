package frustum.contract.ray

import frustum.contract.arithmetic.IntVector

/** Sphere whose centre stays in the box `low`..`high`: register where they differ, constant where not. */
case class RaySphere(low: IntVector, high: IntVector, radius: Int, color: Int) {
  val box: RayBox = RayBox(low, high)
}

/** Box seen from within or through its open front z = low.z: walls at -x, +x, -y, +y and +z, each with its paint, in
  * the order of [[Wall.all]].
  */
case class RayRoom(low: IntVector, high: IntVector, paints: Seq[RayPaint]) {
  require(paints.size == Wall.all.size, s"${paints.size} paints for ${Wall.all.size} walls")
}

object RayRoom {

  /** Checkers on all walls. */
  def apply(low: IntVector, high: IntVector, cellBits: Int): RayRoom =
    RayRoom(low, high, Wall.all.map(_ => RayChecker(cellBits)))
}

/** Square of +-`half` on the room's back wall, centre within `low`..`high` (x and y). */
case class RayQuad(low: IntVector, high: IntVector, half: Int, paint: RayPaint)

object RayQuad {
  def apply(low: IntVector, high: IntVector, half: Int, color: Int): RayQuad =
    RayQuad(low, high, half, RaySolid(color))
}

/** What a ray caster draws; it is generated from this value. Spheres must not intersect one another, for their
  * order along a ray is that of their centres. Colours are 24-bit RGB.
  *
  * @param shaded whether spheres are shaded by the light; otherwise they have their full colour, and need less hardware
  */
case class RayScene(
    camera: RayCameraRange,
    room: RayRoom,
    spheres: Seq[RaySphere],
    quads: Seq[RayQuad],
    light: Option[IntVector],
    background: Int,
    shaded: Boolean = true
) {
  val eye: RayBox = camera.eye

  /** Block RAM of the images, each of which is there once. */
  def imageBits: Int =
    (room.paints ++ quads.map(_.paint)).collect { case i: RayImage => i }.distinct.map(_.rgb.size * 24).sum
  require(spheres.size <= RayScene.MaxSpheres, s"${spheres.size} spheres, at most ${RayScene.MaxSpheres}")
  require(quads.size <= RayScene.MaxQuads, s"${quads.size} quads, at most ${RayScene.MaxQuads}")
  for (a <- 0 to 2)
    require(room.low(a) < room.high(a), s"room of no extent along axis $a: ${room.low(a)} to ${room.high(a)}")
  for (a <- 0 to 1)
    require(
      room.low(a) < eye.low(a) && eye.high(a) < room.high(a),
      s"eye $eye outside the walls ${room.low} to ${room.high}"
    )
  require(eye.high.z < room.high.z, s"eye $eye behind the back wall z = ${room.high.z}")
  for ((s, i) <- spheres.zipWithIndex) {
    require(s.radius > 0, s"sphere $i is degenerate: radius ${s.radius}")
    require(
      s.box.nearest(eye) > s.radius.toLong * s.radius,
      s"eye $eye inside sphere $i: radius ${s.radius}, centre ${s.low} to ${s.high}"
    )
    for (a <- 0 to 2) {
      require(s.low(a) <= s.high(a), s"sphere $i: centre from ${s.low} to ${s.high}")
      require(
        (a == 2 || s.low(a) - s.radius >= room.low(a)) && s.high(a) + s.radius <= room.high(a),
        s"sphere $i leaves the room ${room.low} to ${room.high}: radius ${s.radius}, centre ${s.low} to ${s.high}"
      )
    }
  }
  for ((s, i) <- spheres.zipWithIndex; (o, j) <- spheres.zipWithIndex.drop(i + 1)) {
    val reach = s.radius.toLong + o.radius
    val gap = s.box.nearest(o.box)
    require(
      gap > reach * reach,
      s"spheres $i and $j may intersect: radii ${s.radius} and ${o.radius}, centres ${s.low} to ${s.high} and " +
        s"${o.low} to ${o.high} come as near as the root of $gap, which must exceed ${reach * reach}: move them " +
        "apart or make them smaller"
    )
  }
  for (p <- light; a <- 0 to 2)
    require(
      room.low(a) <= p(a) && p(a) <= room.high(a),
      s"light $p outside the room ${room.low} to ${room.high}"
    )
  for ((q, i) <- quads.zipWithIndex) {
    require(q.half > 0, s"quad $i is degenerate: half size ${q.half}")
    require(!q.paint.isInstanceOf[RayChecker], s"quad $i: checkers are walls' alone")
  }

  /** Whether no wall holds the light: then no ray ends in it. */
  def lightIsFree: Boolean = light.forall(p => Wall.all.forall(w => p(w.axis) != w.position(room)))
}

object RayScene {
  val MaxSpheres = 8
  val MaxQuads = 4
}

/** Where the moving things of a scene are during one frame; the camera only if it moves. */
case class RayMotion(spheres: Seq[IntVector], quads: Seq[IntVector], camera: Option[RayCamera] = None) {
  def cameraOf(scene: RayScene): RayCamera = {
    require(
      camera.isDefined || scene.camera.fixed,
      s"the scene's camera moves: a frame needs one"
    )
    camera.getOrElse(scene.camera.low)
  }
}
