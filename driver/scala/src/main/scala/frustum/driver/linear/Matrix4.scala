package frustum.driver.linear

/** A 4 x 4 matrix for column vectors, as OpenGL uses it.
  *
  * @param rows four rows of four numbers
  */
final case class Matrix4(rows: IndexedSeq[IndexedSeq[Double]]) {
  require(
    rows.length == 4 && rows.forall(_.length == 4),
    s"Matrix4: rows of ${rows.map(_.length).mkString(", ")} numbers"
  )

  /** The matrix that does `m` first, then this. */
  def *(m: Matrix4): Matrix4 = Matrix4(rows.map(row => IndexedSeq.tabulate(4)(k => Matrix4.sum(row, m.rows.map(_(k))))))

  def *(v: Vector4): Vector4 = {
    val column = IndexedSeq(v.x, v.y, v.z, v.w)
    val Seq(x, y, z, w) = rows.map(Matrix4.sum(_, column))
    Vector4(x, y, z, w)
  }

  /** A point, by a matrix that keeps w. */
  def point(v: Vector3): Vector3 = withoutW(this * Vector4.point(v))

  /** A direction: translations do not move it. */
  def direction(v: Vector3): Vector3 = withoutW(this * Vector4.direction(v))

  private def withoutW(v: Vector4) = Vector3(v.x, v.y, v.z)
}

object Matrix4 {
  private def sum(a: IndexedSeq[Double], b: IndexedSeq[Double]) =
    a(0) * b(0) + (a(1) * b(1) + (a(2) * b(2) + a(3) * b(3)))

  private def of(numbers: Double*) = Matrix4(numbers.toIndexedSeq.grouped(4).toIndexedSeq)

  def translation(v: Vector3): Matrix4 = of(1, 0, 0, v.x, 0, 1, 0, v.y, 0, 0, 1, v.z, 0, 0, 0, 1)

  /** About +y by an angle in radians: from +z towards +x. */
  def rotationY(angle: Double): Matrix4 = {
    val (sin, cos) = (scala.math.sin(angle), scala.math.cos(angle))
    of(cos, 0, sin, 0, 0, 1, 0, 0, -sin, 0, cos, 0, 0, 0, 0, 1)
  }

  /** gluPerspective: clip space from a view along -z.
    *
    * @param fovY   vertical field of view, radians
    * @param aspect width / height
    */
  def perspective(fovY: Double, aspect: Double, near: Double, far: Double): Matrix4 = {
    val half = scala.math.tan(fovY / 2)
    val depth = near - far
    of(1 / (half * aspect), 0, 0, 0, 0, 1 / half, 0, 0, 0, 0, (far + near) / depth, 2 * far * near / depth, 0, 0, -1, 0)
  }

  /** glOrtho of a view volume with its middle on the line of sight.
    *
    * @param width,height of the view volume, world units
    */
  def orthographic(width: Double, height: Double, near: Double, far: Double): Matrix4 = {
    val depth = near - far
    of(2 / width, 0, 0, 0, 0, 2 / height, 0, 0, 0, 0, 2 / depth, (far + near) / depth, 0, 0, 0, 1)
  }

  /** gluLookAt: world to view space, the eye at the origin and looking along -z. */
  def lookAt(eye: Vector3, at: Vector3, up: Vector3): Matrix4 = {
    val back = (eye - at).normalized
    val right = up.cross(back).normalized
    val above = back.cross(right)
    def row(v: Vector3) = Seq(v.x, v.y, v.z, -v.dot(eye))
    of(row(right) ++ row(above) ++ row(back) ++ Seq(0.0, 0.0, 0.0, 1.0): _*)
  }
}
