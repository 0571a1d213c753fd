package frustum.contract.raster

import SetupInstruction._
import SetupWords._

/** The microprograms of triangle set-up. With edge functions E1 (through vertices 2, 0) and E2 (through 0, 1),
  * barycentric coordinates are lambda_i = E_i / area, and an attribute u is u0 + lambda1 du1 + lambda2 du2 (Pineda
  * 1988; perspective-correct because s/w, t/w and 1/w are interpolated, Blinn 1992).
  *
  * Lambdas at the first covered pixel come from exact edge functions, so they are in 0..1 without cancellation, however
  * thin the triangle; gradients are used within one tile only.
  *
  * @param planes that are needed; the others' values are undefined
  */
final case class SetupProgram(planes: Seq[Int] = SetupWords.AllPlanes) {
  private def textured = planes.contains(PlaneQ)
  private val nop = SetupInstruction(One, One, Keep, subtract = false, Nowhere)
  private def mac(a: SetupWord, b: SetupWord, start: Start = Keep, to: Result = Nowhere) =
    SetupInstruction(a, b, start, subtract = false, to)
  private def macn(a: SetupWord, b: SetupWord, start: Start = Keep, to: Result = Nowhere) =
    SetupInstruction(a, b, start, subtract = true, to)

  /** Twice the area: dx1 dy2 - dx2 dy1. */
  val area: Seq[SetupInstruction] = Seq(
    mac(DY2_16, DX1, Zero),
    macn(DY1_16, DX2, to = Integer(Area))
  )

  /** 1/area by Newton-Raphson, x := x + x (1 - d x), three steps from a guess with an error of 1/17; meanwhile 1/w,
    * s/w, t/w.
    */
  val attributes: Seq[SetupInstruction] = {
    val x = Reciprocal
    val newton = Seq(
      mac(One, One, Round),
      macn(x, AreaNormal, to = Fraction(Error)),
      mac(x, One, Round),
      mac(x, Error, to = Fraction(x))
    )
    val guess = Seq(mac(Guess, ThreeHalves, Round), macn(Guess, AreaNormal, to = Fraction(x)))
    val depthsOf = (0 to 2).map(v => mac(q(v), scale(v), Zero, Integer(q(v))))
    def products(raw: Int => SetupWord, plane: Int) =
      mac(q(0), raw(0), Round, Fraction(value(plane))) +:
        Seq(1 -> delta1(plane), 2 -> delta2(plane)).flatMap { case (v, d) =>
          Seq(mac(q(v), raw(v), Round), macn(q(0), raw(0), to = Fraction(d)))
        }
    val inverseW = mac(q(0), One16, Zero, Integer(value(PlaneQ))) +:
      Seq(1 -> delta1(PlaneQ), 2 -> delta2(PlaneQ)).flatMap { case (v, d) =>
        Seq(mac(q(v), One16, Zero), macn(q(0), One16, to = Integer(d)))
      }
    val edge0 = Seq(
      mac(DY1_16, One16, Zero),
      macn(DY2_16, One16, to = Integer(A0_16)),
      mac(DX2_16, One16, Zero),
      macn(DX1_16, One16, to = Integer(B0_16))
    )
    val normal = Seq(DY2_16 -> N1A, DX2_16 -> N1B, DY1_16 -> N2A, DX1_16 -> N2B).map { case (from, to) =>
      mac(from, Shift, Zero, Integer(to))
    }
    def texture(program: Seq[SetupInstruction]) = if (textured) program else Nil
    guess ++ texture(depthsOf) ++ newton.take(2) ++ edge0 ++ newton.drop(2) ++ texture(products(
      s,
      PlaneS
    )) ++ newton.take(2) ++
      normal ++ newton.drop(2) ++ texture(products(t, PlaneT)) ++ newton.take(2) ++ texture(inverseW) ++ newton.drop(2)
  }

  /** Gradients of the edge functions, 16 A and 16 B, shifted like the area; they show whether the triangle is a sliver.
    */
  val steps: Seq[SetupInstruction] =
    Seq(DY2_16, DX2_16, DY1_16, DX1_16).zip(Steps).map { case (from, to) => mac(from, Shift4, Zero, Checked(to)) }

  /** Gradients of the lambdas, then of every plane. */
  val gradients: Seq[SetupInstruction] = {
    val Seq(ty2, tx2, ty1, tx1) = Steps
    Seq(
      mac(Reciprocal, ty2, Round, Fraction(L1X)),
      macn(Reciprocal, tx2, Round, Fraction(L1Y)),
      macn(Reciprocal, ty1, Round, Fraction(L2X)),
      mac(Reciprocal, tx1, Round, Fraction(L2Y))
    ) ++ planes.flatMap { p =>
      Seq(
        mac(delta1(p), L1X, RoundGradient),
        mac(delta2(p), L2X, to = GradientX(p)),
        mac(delta1(p), L1Y, RoundGradient),
        mac(delta2(p), L2Y, to = GradientY(p))
      )
    }
  }

  /** The three edge functions where they are largest in the tile, which is skipped if one is negative there; then at
    * the tile's upper corner from which each edge's walk starts. An edge's products have its steps as `b`.
    */
  val edges: Seq[SetupInstruction] = for {
    far <- Seq(true, false)
    at = if (far) 4 else 0
    i <- Seq(
      mac(Left, A0_16, Zero),
      mac(Top, B0_16),
      mac(Area, One16, to = Edge(at)),
      mac(Left, DY2_16, Zero),
      macn(Top, DX2_16, to = Edge(at + 1)),
      macn(Left, DY1_16, Zero),
      mac(Top, DX1_16, to = Edge(at + 2))
    )
  } yield i.copy(far = far)

  /** The lambdas at the first covered pixel and every plane's value there. */
  val rebase: Seq[SetupInstruction] = Seq(
    mac(N1A, PixelX_16, Zero),
    macn(N1B, PixelY_16, to = Integer(Normal1)),
    macn(N2A, PixelX_16, Zero),
    mac(N2B, PixelY_16, to = Integer(Normal2)),
    mac(Reciprocal, Normal1, Round, Fraction(Lambda1)),
    mac(Reciprocal, Normal2, Round, Fraction(Lambda2))
  ) ++ planes.flatMap { p =>
    Seq(mac(value(p), One, Round), mac(delta1(p), Lambda1), mac(delta2(p), Lambda2, to = Initial(p)))
  }

  /** The programs in the engine's memory, with no-operations where a result is not ready. */
  val sections: Seq[Seq[SetupInstruction]] =
    Seq(area, attributes ++ steps, steps, gradients, edges, rebase).map(schedule)
  val starts: Seq[Int] = sections.scanLeft(0)(_ + _.length)
  val image: Seq[SetupInstruction] = sections.flatten

  /** Delays each instruction until its operands are written. Waiting is only allowed before an accumulation starts,
    * because a no-operation would disturb one in progress.
    */
  private def schedule(program: Seq[SetupInstruction]): Seq[SetupInstruction] = {
    val groups = program.foldLeft(Vector.empty[Vector[SetupInstruction]]) { (done, i) =>
      if (i.start == Keep) done.init :+ (done.last :+ i) else done :+ Vector(i)
    }
    groups.foldLeft(Vector.empty[SetupInstruction]) { (done, group) =>
      def ready(at: Int) = group.zipWithIndex.forall { case (i, k) =>
        Seq(i.a, i.b).forall(w =>
          (at + k - ResultLatency + 1 until at).forall(n =>
            n < 0 || n >= done.length || !done(n).result.word.contains(w)
          )
        )
      }
      val at = Iterator.from(done.length).find(ready).get
      done ++ Vector.fill(at - done.length)(nop) ++ group
    }
  }
}

object SetupProgram {
  val SectionArea = 0; val SectionAttributes = 1; val SectionSteps = 2; val SectionGradients = 3; val SectionEdges = 4
  val SectionRebase = 5
}
