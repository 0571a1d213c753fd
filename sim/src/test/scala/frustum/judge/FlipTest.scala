package frustum.judge

import org.scalatest.funsuite.AnyFunSuite

/** Expected means are those of the authors' own evaluator, version 1.7, for the same pictures at 67 pixels a
  * degree.
  */
class FlipTest extends AnyFunSuite {
  private val (width, height) = (48, 40)
  private def picture(f: (Int, Int) => Int) = Array.tabulate(width * height)(i => f(i % width, i / width))
  private def flat(color: Int) = picture((_, _) => color)

  private val pattern = picture((x, y) => (x * 5) << 16 | (y * 6) << 8 | (x * y) % 256)
  private val patched = picture((x, y) =>
    if (x >= 10 && x < 20 && y >= 12 && y < 30) 0xffffff else (x * 5) << 16 | (y * 6) << 8 | (x * y) % 256
  )
  private val tinted = picture((x, y) => ((x * 5 + 20) & 255) << 16 | (y * 6) << 8 | (x * y + 9) % 256)

  test("means agree with the authors' evaluator") {
    val flip = new Flip(width, height)
    for (
      (name, a, b, expected) <- Seq(
        ("equal", pattern, pattern.clone, 0.0),
        ("white patch", pattern, patched, 0.164327),
        ("tint", pattern, tinted, 0.215065),
        ("black and white", flat(0), flat(0xffffff), 0.967401),
        ("green and blue", flat(0x00ff00), flat(0x0000ff), 1.0),
        ("two greys", flat(0x102030), flat(0x182838), 0.158620)
      )
    ) {
      val mean = flip.mean(a, b)
      assert((mean - expected).abs < 2e-4, s"$name: $mean, expected $expected")
    }
  }

  test("every pixel's error lies in 0..1") {
    assert(new Flip(width, height).errors(patched, tinted).forall(e => e >= 0 && e <= 1))
  }
}
