package frustum.spec

import scala.collection.mutable.ArrayBuffer

/** What the set-up of a ray caster computes, and the forms its pixels are decided by.
  *
  * With D the ray's direction, a linear form of the pixel, E the eye, and for each sphere o = C - E:
  * {{{
  * sphere   b = D.o > 0 and b^2 - |D|^2 (|o|^2 - r^2) >= 0
  * wall     n = +-D_a > 0, k its distance from E; hit's coordinate u above the room's corner, times n:
  *          (E_u - low_u) n + k D_u, between 0 and (high_u - low_u) n
  * shadow   v = n (E - P) + k D, parallel to light P to hit; S = C - P; v.S > 0 and
  *          (v.S)^2 - |v|^2 (|S|^2 - r^2) >= 0; or the sphere holds the light
  * shade    with w = -S: D.w, b D.w - |D|^2 (o.w + r^2), |D|^2 and |S|^2 - r^2, see [[RayShade]]
  * }}}
  * All are polynomials of the pixel of at most second degree with whole coefficients, so their signs are exact.
  * Ranges: by Cauchy's inequality a discriminant b^2 - A c lies between -A c and A r^2, D.w within |D| |w|, and where the
  * sphere is hit b D.w - A (o.w + r^2) within A (r |w| + r^2); elsewhere that one wraps.
  *
  * @param inputs
  *   moving coordinates: address of each, with its range
  * @param frame
  *   steps once a frame, then `row` after every row's load
  * @param load
  *   address of the first of `loadWords` words that fill the forms' registers, in the forms' order
  */
case class RayProgram(
    words: IndexedSeq[RayWord],
    inputs: Seq[RayInput],
    frame: Seq[RayStep],
    row: Seq[RayStep],
    load: Int,
    forms: Seq[RayForm]
) {
  val loadWords: Int              = forms.map(_.loadWords).sum
  val wordWidth: Int              = words.map(_.range.width).max
  private val byName              = forms.map(f => f.name -> f).toMap
  def form(name: String): RayForm = byName(name)
  require(
    wordWidth <= RayProgram.MaxWidth,
    s"coefficients of the scene need $wordWidth bits, at most ${RayProgram.MaxWidth}: a smaller room, finer units or fewer pixels"
  )
}

/** A coordinate that moves: `axis` of sphere or quad `index`. */
case class RayInput(isSphere: Boolean, index: Int, axis: Int, address: Int, range: Interval)

object RayProgram {
  val MaxWidth = 64

  def apply(scene: RayScene, width: Int, height: Int): RayProgram = {
    import scene.{camera, room}
    val b       = new RayProgramBuilder
    val algebra = new RayAlgebra(b, width, height)
    import algebra._
    val eye    = camera.eye
    val inputs = ArrayBuffer[RayInput]()
    def moving(isSphere: Boolean, index: Int, low: IntVector, high: IntVector): Seq[RayWord] = (0 to 2).map {
      a =>
        if (low(a) == high(a)) b.constant(low(a))
        else {
          val w = b.word(Interval(low(a), high(a)))
          inputs += RayInput(isSphere, index, a, w.address, w.range)
          w
        }
    }
    val centres = scene.spheres.zipWithIndex.map { case (s, i) => moving(true, i, s.low, s.high) }
    val quads   = scene.quads.zipWithIndex.map { case (q, i) => moving(false, i, q.low, q.high) }

    val direction = (0 to 2).map(a => linear(camera.corner(a), camera.right(a), camera.down(a)))
    def from(p: Seq[RayWord], q: IntVector) = p.zip(q.axes).map { case (w, x) =>
      b.subtract(w, b.constant(x))
    }
    def length2(p: Seq[RayWord]) = p.map(w => b.multiply(w, w)).reduce(b.add)

    /** Polynomials wanted, by name, with their proved range. */
    val wanted = ArrayBuffer[(String, RayPolynomial, Interval)]()

    def wantWithin(name: String, p: RayPolynomial, r: Interval): Unit = wanted += ((name, p, r))
    def want(name: String, p: RayPolynomial): Unit                    = wantWithin(name, p, range(p))
    def discriminant(
        name: String,
        v: Seq[RayPolynomial],
        s: Seq[RayWord],
        radius: Int
    ): (RayPolynomial, RayWord) = {
      val r2    = BigInt(radius).pow(2)
      val c     = b.subtract(length2(s), b.constant(r2))
      val along = dot(v, s)
      val a     = v.map(algebra.square).reduce(add)
      val most  = v.map(range(_).square).reduce(_ + _).high
      val cMost = s.map(_.range.square).reduce(_ + _).high
      wantWithin(name, subtract(algebra.square(along), scale(a, c)), Interval(-most * cMost, most * r2))
      (along, c)
    }

    val square     = direction.map(algebra.square).reduce(add)
    val squareMost = direction.map(range(_).square).reduce(_ + _).high

    /** What a sphere's shade needs besides its discriminant; `away` is from its centre to the light. */
    def wantShade(i: Int, centre: Seq[RayWord], along: RayPolynomial, away: Seq[RayWord]): Unit = {
      def upTo(square: BigInt) = BigInt(scala.math.ceil(scala.math.sqrt(square.toDouble)).toLong + 1)
      def within(m: BigInt)    = Interval(-m, m)
      val r                    = BigInt(scene.spheres(i).radius)
      val far                  = away.map(_.range.square).reduce(_ + _).high
      val towards              = dot(direction, away)
      val across = from(centre, eye).zip(away).map { case (x, y) => b.multiply(x, y) }.reduce(b.add)
      wantWithin(s"towards$i", towards, within(upTo(squareMost * far)))
      wantWithin(
        s"lit$i",
        subtract(product(along, towards), scale(square, b.add(across, b.constant(r * r)))),
        within(squareMost * (r * upTo(far) + r * r))
      )
    }

    for (a <- 0 to 2) want(s"direction$a", direction(a))
    if (scene.shaded && scene.light.isDefined && scene.spheres.nonEmpty)
      wantWithin("square", square, Interval(0, squareMost))
    for (w <- Wall.all) {
      val n = scale(direction(w.axis), b.constant(w.sign))
      for (u <- w.across)
        want(
          s"across${w.index}_$u",
          add(scale(n, b.constant(eye(u) - room.low(u))), scale(direction(u), b.constant(w.distance(scene))))
        )
    }
    for ((p, q) <- Wall.pairs if p.sign > 0 && q.sign > 0) {
      def times(from: Wall, to: Wall) = scale(direction(from.axis), b.constant(to.distance(scene)))
      want(s"before${p.index}_${q.index}", subtract(times(p, q), times(q, p)))
    }
    for ((q, i) <- quads.zipWithIndex; u <- 0 to 1) {
      val wall   = Wall.back
      val offset = b.subtract(b.constant(eye(u) + scene.quads(i).half), q(u))
      val low    = add(scale(direction(2), offset), scale(direction(u), b.constant(wall.distance(scene))))
      want(s"quad${i}_$u", low)
      want(s"quadEnd${i}_$u", subtract(scale(direction(2), b.constant(2 * scene.quads(i).half)), low))
    }
    for ((centre, i) <- centres.zipWithIndex) {
      val (along, _) = discriminant(s"sphere$i", direction, from(centre, eye), scene.spheres(i).radius)
      want(s"along$i", along)
      for (light <- scene.light) {
        val s = from(centre, light)
        if (scene.shaded) wantShade(i, centre, along, s.map(b.subtract(b.constant(0), _)))
        for (w <- Wall.all) {
          val n = scale(direction(w.axis), b.constant(w.sign))
          val v = (0 to 2).map { a =>
            add(scale(n, b.constant(eye(a) - light(a))), scale(direction(a), b.constant(w.distance(scene))))
          }
          val (gate, c) = discriminant(s"shadow${i}_${w.index}", v, s, scene.spheres(i).radius)
          want(s"gate${i}_${w.index}", gate)
          if (w == Wall.back)
            wantWithin(s"power$i", RayPolynomial(c +: Seq.fill(5)(b.constant(0))), c.range)
        }
      }
    }
    build(b, wanted.toSeq, inputs.toSeq, width, height)
  }

  /** Lays the state words out and writes the steps that start and advance them. */
  private def build(
      b: RayProgramBuilder,
      wanted: Seq[(String, RayPolynomial, Interval)],
      inputs: Seq[RayInput],
      width: Int,
      height: Int
  ): RayProgram = {
    val rows                     = Interval(0, height)
    def degree(p: RayPolynomial) = {
      val quadratic = p.c.drop(3).exists(!_.constant.contains(BigInt(0)))
      val linear    = p.c.slice(1, 3).exists(!_.constant.contains(BigInt(0)))
      if (quadratic) 3 else if (linear) 2 else 1
    }
    // Start values are made first, so that the state words can follow one another.
    val starts = wanted.map { case (_, p, r) =>
      val Seq(c, x, y, xx, xy, yy) = p.c
      val column                   = (c.range + y.range * rows + yy.range * rows.square)
      val value                    = Interval(column.low.min(r.low), column.high.max(r.high))
      degree(p) match {
        case 1 => Seq((c, c.range))
        case 2 => Seq((c, value), (x, x.range))
        case 3 =>
          val step = b.add(x, xx)
          Seq((c, value), (step, step.range + xy.range * rows), (b.add(xx, xx), (xx.range + xx.range)))
      }
    }
    val rowSteps = wanted.map { case (_, p, _) =>
      if (degree(p) == 3) Some((b.add(p.c(2), p.c(5)), b.add(p.c(5), p.c(5)))) else None
    }
    val load  = b.words.size
    val state = starts.map(_.zipWithIndex.map { case ((_, range), i) =>
      if (i == 2) b.word(Interval(0)) // the gap of RayForm.slot
      b.word(range)
    })
    for ((s, from) <- state.zip(starts); (to, (w, _)) <- s.zip(from)) b.copy(to, w)
    for (((s, (_, p, _)), steps) <- state.zip(wanted).zip(rowSteps)) steps match {
      case Some((first, curve)) =>
        val slope = b.word(first.range + curve.range * rows)
        b.copy(slope, first)
        b.advance(s(0), slope)
        b.advance(slope, curve)
        b.advance(s(1), p.c(4))
      case None => if (s.size > 1) b.advance(s(0), p.c(2))
    }
    val forms = wanted.zip(state).map { case ((name, _, r), s) =>
      RayForm(name, s.head.address - load, s.size, r)
    }
    RayProgram(b.words.toIndexedSeq, inputs, b.frame.toSeq, b.row.toSeq, load, forms)
  }
}
