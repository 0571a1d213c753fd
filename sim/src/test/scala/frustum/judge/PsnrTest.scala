package frustum.judge

import org.scalatest.funsuite.AnyFunSuite

class PsnrTest extends AnyFunSuite {
  test("equal pictures have none, black against white 0 dB, one level everywhere 48.13 dB") {
    val grey = Array.fill(100)(0x808080)
    assert(Psnr.of(grey, grey.clone).isEmpty)
    assert(Psnr.of(Array.fill(10)(0), Array.fill(10)(0xffffff)).exists(_.abs < 1e-12))
    assert(Psnr.of(grey, Array.fill(100)(0x817f81)).exists(d => (d - 48.1308).abs < 1e-4))
  }

  test("one channel of one pixel counts as a third of that pixel") {
    val other = Array.fill(100)(0x808080); other(7) = 0x808083
    assert(Psnr.squaredError(Array.fill(100)(0x808080), other) == 9.0)
  }
}
