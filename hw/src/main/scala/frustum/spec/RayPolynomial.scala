package frustum.spec

/** c00 + h + v + h^2 + h v + v^2 with words as coefficients, in this order; linear if the last three are 0. */
case class RayPolynomial(c: Seq[RayWord]) {
  require(c.size == 6, s"${c.size} coefficients")
}

/** Arithmetic on polynomials of the pixel coordinates for `b`. */
class RayAlgebra(b: RayProgramBuilder, width: Int, height: Int) {
  private val h = Interval(0, width)
  private val v = Interval(0, height)

  def constant(x: BigInt): RayWord                              = b.constant(x)
  def linear(c0: BigInt, ch: BigInt, cv: BigInt): RayPolynomial =
    RayPolynomial(Seq(c0, ch, cv, BigInt(0), BigInt(0), BigInt(0)).map(constant))
  def scale(p: RayPolynomial, by: RayWord): RayPolynomial    = RayPolynomial(p.c.map(b.multiply(_, by)))
  def add(p: RayPolynomial, q: RayPolynomial): RayPolynomial =
    RayPolynomial(p.c.zip(q.c).map { case (x, y) => b.add(x, y) })
  def subtract(p: RayPolynomial, q: RayPolynomial): RayPolynomial =
    RayPolynomial(p.c.zip(q.c).map { case (x, y) => b.subtract(x, y) })
  def dot(p: Seq[RayPolynomial], w: Seq[RayWord]): RayPolynomial =
    p.zip(w).map { case (x, y) => scale(x, y) }.reduce(add)

  private def parts(p: RayPolynomial): Seq[RayWord] = {
    require(p.c.drop(3).forall(_.constant.contains(BigInt(0))), "product of a form that is not linear")
    p.c.take(3)
  }

  /** Product of two linear forms. */
  def product(p: RayPolynomial, q: RayPolynomial): RayPolynomial = {
    val Seq(c, x, y)                                          = parts(p)
    val Seq(d, s, t)                                          = parts(q)
    def cross(a: RayWord, e: RayWord, f: RayWord, g: RayWord) = b.add(b.multiply(a, e), b.multiply(f, g))
    RayPolynomial(
      Seq(
        b.multiply(c, d),
        cross(c, s, x, d),
        cross(c, t, y, d),
        b.multiply(x, s),
        cross(x, t, y, s),
        b.multiply(y, t)
      )
    )
  }

  /** Square of a linear form. */
  def square(p: RayPolynomial): RayPolynomial = {
    val Seq(c, x, y)      = parts(p)
    def twice(w: RayWord) = b.add(w, w)
    RayPolynomial(
      Seq(
        b.multiply(c, c),
        twice(b.multiply(c, x)),
        twice(b.multiply(c, y)),
        b.multiply(x, x),
        twice(b.multiply(x, y)),
        b.multiply(y, y)
      )
    )
  }

  /** Range over the picture, from the ranges of the coefficients; constant linear forms exactly. */
  def range(p: RayPolynomial): Interval =
    p.c.map(_.range).zip(Seq(Interval(1), h, v, h.square, h * v, v.square)).map { case (x, y) =>
      x * y
    }.reduce(_ + _)
}
