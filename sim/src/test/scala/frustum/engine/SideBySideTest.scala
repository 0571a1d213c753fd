package frustum.engine

import org.scalatest.funsuite.AnyFunSuite
import scala.collection.mutable.ArrayBuffer

class SideBySideTest extends AnyFunSuite {
  private def numbers(n: Int)(each: Int => Unit): Unit = (0 until n).foreach(each)

  test("the results of both come in pairs, and neither runs ahead") {
    @volatile var made = 0
    val pairs = ArrayBuffer.empty[(Int, Int)]
    SideBySide[Int, Int](each => numbers(50) { n => made = n; each(n) }, numbers(50)) { (a, b) =>
      pairs += a -> b
      assert(made <= b + 2, "one waits, one is being handed over")
    }
    assert(pairs.toSeq == (0 until 50).map(n => n -> n))
  }

  test("the failure of either side is thrown, and the other ends") {
    def failing(n: Int)(each: Int => Unit): Unit = { numbers(n)(each); throw new IllegalStateException(s"after $n") }
    for (n <- Seq(0, 3)) {
      val first = intercept[IllegalStateException](SideBySide[Int, Int](failing(n), numbers(9))((_, _) => ()))
      assert(first.getMessage == s"after $n")
      val second = intercept[IllegalStateException](SideBySide[Int, Int](numbers(9), failing(n))((_, _) => ()))
      assert(second.getMessage == s"after $n")
    }
    val taker = intercept[IllegalStateException](
      SideBySide[Int, Int](numbers(9), numbers(9))((a, _) => if (a == 4) throw new IllegalStateException("taker"))
    )
    assert(taker.getMessage == "taker")
  }

  test("one result more or less on a side is an error") {
    intercept[IllegalStateException](SideBySide[Int, Int](numbers(3), numbers(4))((_, _) => ()))
    intercept[IllegalStateException](SideBySide[Int, Int](numbers(4), numbers(3))((_, _) => ()))
    intercept[IllegalStateException](SideBySide[Int, Int](numbers(9), numbers(3))((_, _) => ()))
  }
}
