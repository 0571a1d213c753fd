package frustum.contract.ray

import frustum.contract.arithmetic.Interval

/** c00 + h + v + h^2 + h v + v^2 with words as coefficients, in this order; linear if the last three are 0.
  *
  * @param bound
  *   range over the picture and one pixel beyond its right and lower borders
  */
case class RayPolynomial(c: Seq[RayWord], bound: Interval) {
  require(c.size == 6, s"${c.size} coefficients")
}

/** Arithmetic on polynomials of the pixel coordinates for `b`. Each result's bound is what follows from the operands'
  * bounds and what follows from its coefficients, the narrower of both.
  */
class RayAlgebra(b: RayProgramBuilder, width: Int, height: Int) {
  private val h = Interval(0, width)
  private val v = Interval(0, height)

  private def polynomial(c: Seq[RayWord], bound: Option[Interval]) = {
    val spread =
      c.map(_.range).zip(Seq(Interval(1), h, v, h.square, h * v, v.square)).map { case (x, y) =>
        x * y
      }.reduce(_ + _)
    RayPolynomial(c, bound.fold(spread)(_.within(spread)))
  }
  private def padded(c: Seq[RayWord]) = c.padTo(6, b.constant(0))

  def constant(x: RayWord): RayPolynomial = polynomial(padded(Seq(x)), None)

  /** @param bound of its values, if one is known in addition to that of the coefficients */
  def linear(c0: RayWord, ch: RayWord, cv: RayWord, bound: Option[Interval]): RayPolynomial =
    polynomial(padded(Seq(c0, ch, cv)), bound)
  def scale(p: RayPolynomial, by: RayWord): RayPolynomial =
    polynomial(p.c.map(b.multiply(_, by)), Some(p.bound * by.range))
  def add(p: RayPolynomial, q: RayPolynomial): RayPolynomial =
    polynomial(p.c.zip(q.c).map { case (x, y) => b.add(x, y) }, Some(p.bound + q.bound))
  def subtract(p: RayPolynomial, q: RayPolynomial): RayPolynomial =
    polynomial(p.c.zip(q.c).map { case (x, y) => b.subtract(x, y) }, Some(p.bound - q.bound))
  def dot(p: Seq[RayPolynomial], w: Seq[RayWord]): RayPolynomial =
    p.zip(w).map { case (x, y) => scale(x, y) }.reduce(add)

  private def parts(p: RayPolynomial): Seq[RayWord] = {
    require(p.c.drop(3).forall(_.constant.contains(BigInt(0))), "product of a form that is not linear")
    p.c.take(3)
  }

  /** Product of two linear forms. */
  def product(p: RayPolynomial, q: RayPolynomial): RayPolynomial = {
    val Seq(c, x, y) = parts(p)
    val Seq(d, s, t) = parts(q)
    def cross(a: RayWord, e: RayWord, f: RayWord, g: RayWord) = b.add(b.multiply(a, e), b.multiply(f, g))
    polynomial(
      Seq(
        b.multiply(c, d),
        cross(c, s, x, d),
        cross(c, t, y, d),
        b.multiply(x, s),
        cross(x, t, y, s),
        b.multiply(y, t)
      ),
      Some(p.bound * q.bound)
    )
  }

  /** Square of a linear form. */
  def square(p: RayPolynomial): RayPolynomial = {
    val Seq(c, x, y) = parts(p)
    def twice(r: RayWord, s: RayWord) = { val w = b.multiply(r, s); b.add(w, w) }
    polynomial(
      Seq(b.multiply(c, c), twice(c, x), twice(c, y), b.multiply(x, x), twice(x, y), b.multiply(y, y)),
      Some(p.bound.square)
    )
  }
}
