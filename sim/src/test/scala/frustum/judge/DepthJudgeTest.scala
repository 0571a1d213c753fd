package frustum.judge

import frustum.contract.raster.{Combine, FramePass, RenderState, TexelFormat, TextureRef}
import frustum.judge.Passes._
import frustum.reference.raster.{ReferenceFrame, ReferenceRaster}
import org.scalatest.funsuite.AnyFunSuite

class DepthJudgeTest extends AnyFunSuite {
  private def judge(pass: FramePass, fragments: Iterable[LoggedFragment], memory: Array[Int] = memory) = {
    val reference = new ReferenceFrame(config)
    ReferenceRaster.drawPass(reference, pass, memory, 0, _ => ())
    new DepthJudge(pass, config, memory).judge(fragments, reference)
  }

  test("the reference's own depths are in order") {
    val scene = Passes.random(3, 60)
    val verdict = judge(scene, log(scene))
    // Depths are told as whole numbers, so that near-ties may be decided otherwise.
    assert(verdict.primitiveWrong <= 3 && verdict.depthOrderWrong <= 3)
  }

  test("depths that come out wrong are found, once a pixel") {
    val two = pass(Seq(RenderState()), quad(0, 0, 8, 8, z = 100) ++ quad(4, 0, 12, 8, z = 200): _*)
    val swapped = log(two).map(f => f.copy(depth = 300 - f.depth))
    assert(judge(two, log(two)) == DepthVerdict(0, 0) && judge(two, swapped) == DepthVerdict(32, 32))
  }

  test("missing pixels are another primitive, not another order") {
    val one = pass(Seq(RenderState()), quad(0, 0, 8, 8): _*)
    assert(judge(one, log(one).drop(5)) == DepthVerdict(5, 0))
  }

  test("holes of an alpha-tested texture let through what is behind") {
    val holes =
      RenderState(Some(TextureRef(0, 3, 3, TexelFormat.Rgba4444)), combine = Combine.Replace, alphaRef = 16)
    val grid = Array.tabulate(32768)(i => if (i % 2 == 0) 0xffff else 0xfff0)
    val scene = pass(Seq(RenderState(), holes), quad(0, 0, 8, 8, 0, 200) ++ quad(0, 0, 8, 8, 1, 100): _*)
    val fragments = log(scene)
    assert(judge(scene, fragments, grid) == DepthVerdict(0, 0))
    val wrongTexel = fragments.map(f => f.copy(texelS = f.texelS ^ 1))
    assert(judge(scene, wrongTexel, grid) == DepthVerdict(64, 32))
  }
}
