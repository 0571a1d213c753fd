package frustum.scene

import org.scalatest.funsuite.AnyFunSuite
import scala.util.Random

class AreaAverageTest extends AnyFunSuite {
  private def average(width: Int, height: Int, argb: IndexedSeq[Int], newWidth: Int, newHeight: Int) =
    AreaAverage(width, height, y => argb.slice(y * width, (y + 1) * width).toArray, newWidth, newHeight).toIndexedSeq

  test("one colour stays as it is at every size") {
    for (w <- 1 to 20; h <- 1 to 20; color <- Seq(0xff336699, 0x80ff8001, 0xffffffff))
      assert(average(w, h, IndexedSeq.fill(w * h)(color), 8, 16).forall(_ == color))
  }

  test("whole multiples: the mean of each block; larger: each texel repeated") {
    val random = new Random(3)
    val picture = IndexedSeq.fill(24 * 16)(0xff000000 | random.nextInt(0x1000000))
    val smaller = average(24, 16, picture, 8, 8)
    for (y <- 0 until 8; x <- 0 until 8; at <- Seq(16, 8, 0)) {
      val block = for (v <- 0 until 2; u <- 0 until 3) yield picture((2 * y + v) * 24 + 3 * x + u) >> at & 255
      assert((smaller(y * 8 + x) >> at & 255) == math.round(block.sum / 6.0))
    }
    val larger = average(24, 16, picture, 48, 64)
    for (y <- 0 until 64; x <- 0 until 48) assert(larger(y * 48 + x) == picture(y / 4 * 24 + x / 2))
  }

  test("other sizes: texels by the part of them that is covered") {
    // three texels to two: 0, 60, 240 become (0 + 30) / 1.5 and (30 + 240) / 1.5
    val grey = IndexedSeq(0, 60, 240).map(_ * 0x010101 | 0xff000000)
    assert(average(3, 1, grey, 2, 1) == IndexedSeq(20, 180).map(_ * 0x010101 | 0xff000000))
    assert(average(1, 3, grey, 1, 2) == IndexedSeq(20, 180).map(_ * 0x010101 | 0xff000000))
  }

  test("colours under transparent texels do not show") {
    assert(average(2, 1, IndexedSeq(0xffff0000, 0x0000ff00), 1, 1) == IndexedSeq(0x80ff0000))
    assert(average(2, 1, IndexedSeq(0x00ff0000, 0x0000ff00), 1, 1) == IndexedSeq(0))
  }

  test("sizes: exact ones kept, others the largest that fit together, or what is asked for") {
    assert(TextureSizes(Seq((8, 128), (300, 200), (64, 12)), 32768, None) == Seq((8, 128), (128, 128), (64, 128)))
    assert(TextureSizes(Seq((300, 200)), 32768, None) == Seq((128, 128)))
    assert(TextureSizes(Seq((300, 64), (5, 3)), 32768, None) == Seq((128, 64), (128, 128)))
    assert(TextureSizes(Seq((8, 128), (300, 16)), 32768, Some(64)) == Seq((8, 128), (64, 16)))
    assert(TextureSizes(Seq.fill(3)((128, 128)), 32768, None) == Seq.fill(3)((64, 64)))
    assert(TextureSizes(Seq.fill(16)((1024, 1024)), 32768, None) == Seq.fill(16)((32, 32)))
  }
}
