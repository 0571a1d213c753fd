package frustum.judge

import frustum.contract.raster.TileRegion
import frustum.judge.Passes._
import org.scalatest.funsuite.AnyFunSuite

class CoverageJudgeTest extends AnyFunSuite {
  private val scene = Passes.random(11, 150)
  private val truth = log(scene)
  private def judge(f: Iterable[LoggedFragment]) = CoverageJudge.judge(scene, f, config)

  test("what the reference covers is right") {
    assert(judge(truth).wrong == 0 && judge(truth).covered == truth.length && truth.length > 1000)
  }

  test("a dropped, a doubled and a foreign pixel are each found") {
    assert(judge(truth.tail) == CoverageVerdict(truth.length, 1, 0, 0))
    assert(judge(truth :+ truth(17)) == CoverageVerdict(truth.length, 0, 0, 1))
    assert(judge(truth :+ truth(17).copy(triangle = 999)).extra == 1)
    assert(judge(truth :+ truth(17).copy(x = config.width)).extra == 1)
    val moved = truth.updated(0, truth.head.copy(triangle = truth.last.triangle, x = 0, y = 0))
    assert(judge(moved).missing == 1 && judge(moved).extra == 1)
  }

  test("edges that are all inclusive hit the shared ones twice") {
    val square = pass(Seq(textured), quad(8.5, 8.5, 16.5, 16.5): _*)
    val all = for (t <- 0 to 1; y <- 8 to 16; x <- 8 to 16; d = (x - y) * (1 - 2 * t) if d >= 0)
      yield LoggedFragment(t, x, y, 0, 0, 0)
    val verdict = CoverageJudge.judge(square, all, config)
    // The exact set is 8 x 8; inclusive edges add the right column, the bottom row and one diagonal.
    assert(verdict == CoverageVerdict(64, 0, all.length - 64, 0) && verdict.extra == 2 * 8 + 1 + 9)
  }

  test("pixels outside the pass's region are extra") {
    val part = scene.copy(region = TileRegion(0, 0, 0, config.tilesY - 1))
    val outside = truth.count(_.x >= config.tileWidth)
    assert(CoverageJudge.judge(part, truth, config) == CoverageVerdict(truth.length - outside, 0, outside, 0))
  }
}
