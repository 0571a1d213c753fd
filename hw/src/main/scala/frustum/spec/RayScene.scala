package frustum.spec

/** Ray of pixel (h, v), unnormalised: corner + h right + v down, from `eye`. Integers, so that every decision
  * on a picture is exact for the camera as it stands here.
  */
case class RayCamera(eye: IntVector, corner: IntVector, right: IntVector, down: IntVector) {
  def direction(h: Int, v: Int): IntVector = {
    def at(a: Int) = corner(a) + h * right(a) + v * down(a)
    IntVector(at(0), at(1), at(2))
  }
}

object RayCamera {

  /** Looks along +z with `focal` units to the screen plane, 1 unit a pixel. Directions are doubled, so that
    * rays through the centres of pixels are whole numbers; `centred` = false takes their lower left corners
    * (h - width / 2, height / 2 - 1 - v).
    */
  def forward(
      eye: IntVector,
      width: Int,
      height: Int,
      focal: Int,
      pixel: Int = 1,
      centred: Boolean = true
  ): RayCamera = {
    val (x, y) = if (centred) (1 - width, height - 1) else (-width, height - 2)
    RayCamera(
      eye,
      IntVector(x * pixel, y * pixel, 2 * focal),
      IntVector(2 * pixel, 0, 0),
      IntVector(0, -2 * pixel, 0)
    )
  }
}

/** Sphere whose centre stays in the box `low`..`high`: register where they differ, constant where not. */
case class RaySphere(low: IntVector, high: IntVector, radius: Int, color: Int) {

  /** Squares of the least and the greatest distance of its centre from a point. */
  def nearest(p: IntVector): Long =
    square(a => scala.math.max(0, scala.math.max(low(a) - p(a), p(a) - high(a))))
  def farthest(p: IntVector): Long = square(a => scala.math.max((low(a) - p(a)).abs, (high(a) - p(a)).abs))

  /** Square of the least distance between its centre and that of another. */
  def gap(o: RaySphere): Long =
    square(a => scala.math.max(0, scala.math.max(low(a) - o.high(a), o.low(a) - high(a))))
  private def square(along: Int => Int): Long = (0 to 2).map(a => along(a).toLong * along(a)).sum
}

/** Box seen from within or through its open front z = low.z: walls at -x, +x, -y, +y and +z, painted as a
  * checkerboard: red, green, blue are bit `cellBits` of floor(hit - low).
  */
case class RayRoom(low: IntVector, high: IntVector, cellBits: Int)

/** Square of +-`half` on the room's back wall, centre within `low`..`high` (x and y). */
case class RayQuad(low: IntVector, high: IntVector, half: Int, color: Int)

/** What a ray caster draws; it is generated from this value. Spheres must not intersect one another, for their
  * order along a ray is that of their centres. Colours are 24-bit RGB.
  *
  * @param shaded whether spheres are shaded by the light; otherwise they have their full colour, and need less hardware
  */
case class RayScene(
    camera: RayCamera,
    room: RayRoom,
    spheres: Seq[RaySphere],
    quads: Seq[RayQuad],
    light: Option[IntVector],
    background: Int,
    shaded: Boolean = true
) {
  import camera.eye
  require(spheres.size <= RayScene.MaxSpheres, s"${spheres.size} spheres, at most ${RayScene.MaxSpheres}")
  require(quads.size <= RayScene.MaxQuads, s"${quads.size} quads, at most ${RayScene.MaxQuads}")
  for (a <- 0 to 2)
    require(room.low(a) < room.high(a), s"room of no extent along axis $a: ${room.low(a)} to ${room.high(a)}")
  for (a <- 0 to 1)
    require(
      room.low(a) < eye(a) && eye(a) < room.high(a),
      s"eye $eye outside the walls ${room.low} to ${room.high}"
    )
  require(eye.z < room.high.z, s"eye $eye behind the back wall z = ${room.high.z}")
  require(room.cellBits >= 0 && room.cellBits <= 12, s"checker cells of 2^${room.cellBits}")
  for ((s, i) <- spheres.zipWithIndex) {
    require(s.radius > 0, s"sphere $i is degenerate: radius ${s.radius}")
    require(
      s.nearest(eye) > s.radius.toLong * s.radius,
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
    require(
      s.gap(o) > reach * reach,
      s"spheres $i and $j may intersect: radii ${s.radius} and ${o.radius}, centres ${s.low} to ${s.high} and ${o.low} to ${o.high} " +
        s"come as near as the root of ${s.gap(o)}, which must exceed ${reach * reach}: move them apart or make them smaller"
    )
  }
  for (p <- light; a <- 0 to 2)
    require(
      room.low(a) <= p(a) && p(a) <= room.high(a),
      s"light $p outside the room ${room.low} to ${room.high}"
    )
  for ((q, i) <- quads.zipWithIndex) require(q.half > 0, s"quad $i is degenerate: half size ${q.half}")
}

object RayScene {
  val MaxSpheres = 8
  val MaxQuads   = 4
}

/** Where the moving things of a scene are during one frame. */
case class RayMotion(spheres: Seq[IntVector], quads: Seq[IntVector])
