package frustum.reference.raster

import org.scalatest.funsuite.AnyFunSuite
import scala.concurrent.ExecutionContext.Implicits.global
import scala.concurrent.duration.DurationInt
import scala.concurrent.{Await, Future}

/** Commands of one checkout run side by side, and each compiles the program. Skipped where Mesa or gcc is missing. */
class MesaProgramTest extends AnyFunSuite {

  /** One triangle on 8 x 8 pixels. */
  private val input = "8 8 0 0 1\n3 3 0 0 1 0 0 1\n0 0 0 1 0 0 1\n8 0 0 1 0 0 1\n8 8 0 1 0 0 1"

  test("a program that is compiled while it runs is never met half made") {
    val program = MesaProgram.compiled("draw").getOrElse(cancel(Mesa.Missing))
    val compile = Future((0 until 8).map(_ => MesaProgram.compiled("draw")))
    val run = Future((0 until 24).map(_ => program.run(input).toSeq))
    assert(Await.result(run, 5.minutes).distinct.length == 1)
    assert(Await.result(compile, 5.minutes).forall(_.isDefined))
  }
}
