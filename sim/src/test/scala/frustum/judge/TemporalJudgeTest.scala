package frustum.judge

import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite

class TemporalJudgeTest extends AnyFunSuite {
  private def cube(bits: Int) = TemporalJudge.pan(Scenes.cube, TemporalJudge.Config, bits)

  test("vertices on whole pixels make texels pop, on sixteenths they swim by a fraction and none pops") {
    val (coarse, fine) = (cube(0), cube(4))
    assert(coarse.popsPercent > 0 && coarse.swimRms > 4 * fine.swimRms, s"$coarse, $fine")
    assert(fine.popsPercent == 0 && fine.swimMost < 0.25, fine)
  }

  test("every textured scene swims by something") {
    for (name <- Seq("floor", "corridor", "terrain"))
      assert(TemporalJudge.pan(Scenes.byName(name), TemporalJudge.Config, 4).swimRms > 0, name)
  }

  test("what has no texture swims by nothing") {
    val plain = Scenes.teapot(2)
    assert(plain.materials.forall(_.texture.isEmpty))
    assert(TemporalJudge.pan(plain, TemporalJudge.Config, 4) == TemporalVerdict(0, 0, 0))
  }
}
