package frustum.fragment

import frustum.model
import org.scalatest.funsuite.AnyFunSuite

/** The blending unit itself is held to this model by the pipeline's tests, since it ends in the tile memory.
  */
class BlendTest extends AnyFunSuite {
  test("blending is exact at both ends of alpha and between equal colours, and nearest elsewhere") {
    for (source <- 0 until 64; target <- 0 until 64; a <- 0 until 32) {
      val w = a + (a >> 4)
      val exact = (source * w + target * (32 - w)) / 32.0
      val got = model.fragment.Blend.channel(source, target, a)
      assert((got - exact).abs <= 0.5)
      if (a == 0) assert(got == target)
      if (a == 31) assert(got == source)
      if (source == target) assert(got == source)
    }
  }
}
