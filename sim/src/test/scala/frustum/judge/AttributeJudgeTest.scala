package frustum.judge

import frustum.contract.raster.{FramePass, Wrap}
import frustum.judge.Passes._
import org.scalatest.funsuite.AnyFunSuite

class AttributeJudgeTest extends AnyFunSuite {

  /** A floor: near at the bottom with w = 1, far at the top with w = 8. */
  private val floor: FramePass = {
    val (a, b) = (vertex(0, 4, w = 8, s = 0, t = 3), vertex(64, 4, w = 8, s = 4, t = 3))
    val (c, d) = (vertex(64, 48, w = 1, s = 4, t = 0), vertex(0, 48, w = 1, s = 0, t = 0))
    pass(Seq(textured), (0, Seq(a, b, c)), (0, Seq(a, c, d)))
  }
  private val truth = log(floor)

  test("the reference's own texels are right, nearly all are judged") {
    val verdict = AttributeJudge.judge(floor, truth)
    assert(verdict.wrong == 0 && verdict.maxError == 0 && verdict.judged > truth.length * 0.98)
  }

  test("a shift by one texel is found everywhere, also across the wrap") {
    val shifted = AttributeJudge.judge(floor, truth.map(f => f.copy(texelS = (f.texelS + 1) % 16)))
    assert(shifted.wrong == shifted.judged && shifted.maxError == 1 && shifted.wrongByMoreThanOne == 0)
    val two = AttributeJudge.judge(floor, truth.map(f => f.copy(texelT = (f.texelT + 14) % 16)))
    assert(two.wrongByMoreThanOne == two.judged && two.maxError == 2)
  }

  test("affine mapping is found") {
    // The same triangles with w = 1 everywhere are what an affine interpolator computes.
    val affine = log(floor.copy(vertices = floor.vertices.map(_.copy(qMantissa = 32768, qExponent = 16))))
    val verdict = AttributeJudge.judge(floor, affine)
    assert(
      verdict.wrong > verdict.judged / 2 && verdict.wrongByMoreThanOne > verdict.judged / 3 &&
        verdict.maxError > 2
    )
  }

  test("within 1/1024 texel of a border nothing is judged") {
    def judged(offset: Double) = AttributeJudge.judge(
      pass(
        Seq(textured),
        (
          0,
          Seq(
            vertex(0, 0, s = offset, t = 0.03),
            vertex(40, 0, s = offset, t = 0.03),
            vertex(0, 40, s = offset, t = 0.03)
          )
        )
      ),
      Seq(LoggedFragment(0, 2, 2, 0, 0, 0))
    ).judged
    assert(judged(0) == 0 && judged(3 / 65536.0) == 0 && judged(5 / 65536.0) == 1)
  }

  test("distances in each wrap mode") {
    assert(AttributeJudge.distance(0.5, 15, 16, Wrap.Repeat) == 1 && AttributeJudge.distance(
      -0.5,
      0,
      16,
      Wrap.Repeat
    ) == 1)
    assert(AttributeJudge.distance(20.5, 15, 16, Wrap.Clamp) == 0 && AttributeJudge.distance(
      0.5,
      15,
      16,
      Wrap.Clamp
    ) == 15)
    assert(AttributeJudge.distance(16.5, 15, 16, Wrap.Mirror) == 0 && AttributeJudge.distance(
      -1.5,
      0,
      16,
      Wrap.Mirror
    ) == 1)
  }
}
