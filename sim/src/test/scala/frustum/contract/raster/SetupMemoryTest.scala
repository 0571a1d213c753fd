package frustum.contract.raster

import frustum.contract.raster.SetupInstruction._
import org.scalatest.funsuite.AnyFunSuite

import scala.util.Random

class SetupMemoryTest extends AnyFunSuite {

  /** Sets of planes: those of the texture go together. */
  private val choices = {
    import SetupWords._
    val others = Seq(PlaneZ, PlaneR, PlaneG, PlaneB, PlaneA).toSet.subsets().map(_.toSeq).toSeq
    for (textured <- Seq(true, false); rest <- others if textured || rest.nonEmpty)
      yield ((if (textured) Seq(PlaneS, PlaneT, PlaneQ) else Nil) ++ rest).sorted
  }

  /** What a step reads, by the values of the places or words there, and where its result goes. */
  private def trace[P](planes: Seq[Int], place: SetupWord => P, initial: Map[P, Long]): Seq[Seq[Long]] = {
    val program = SetupProgram(planes)
    val memory = scala.collection.mutable.Map.empty[P, Long] ++ initial
    var count = 0L
    def written(w: SetupWord) = { count += 1; memory(place(w)) = count }
    def read(w: SetupWord) = memory.getOrElse(place(w), -1L)
    def fetch(r: FetchProgram.Row*) = r.filter(_.from != FetchProgram.Source.Skip).map { row =>
      val was = Seq(read(row.origin))
      written(row.target)
      was
    }
    def run(section: Seq[SetupInstruction]) = section.map { i =>
      val was = (Seq(i.a, i.b) ++ SetupWords.pairs.collect { case (first, second) if first eq i.a => second }).map(read)
      i.result.word.foreach(written)
      was
    }
    import FetchProgram._
    def setUp(sliver: Boolean) = fetch((0 to 2).flatMap(vertex(_, planes)): _*) ++ run(program.area) ++
      fetch(normal ++ gradientShift: _*) ++ run(program.attributes ++ program.steps) ++
      (if (sliver) fetch(gradientShift: _*) ++ run(program.steps) else Nil) ++ run(program.gradients)
    def move = fetch(corner: _*) ++ run(program.edges) ++ fetch(pixel: _*) ++ run(program.rebase)
    Seq(false, true).flatMap(sliver => setUp(sliver) ++ move ++ move)
  }

  test("places that words share hold for every step what a place of its own would") {
    for (planes <- choices) {
      val memory = SetupMemory(planes)
      val constants =
        SetupWords.all.zipWithIndex.collect { case (w, n) if w.kind.isInstanceOf[SetupWord.Constant] => w -> (-2L - n) }
      val shared = trace(planes, memory.code, constants.map { case (w, v) => memory.code(w) -> v }.toMap)
      assert(shared == trace[SetupWord](planes, w => w, constants.toMap), planes)
    }
  }

  test("pairs lie as the hardware reads them, and 21 words suffice for what took 26") {
    for (planes <- choices; memory = SetupMemory(planes)) {
      assert(memory.sharedWords <= 21 && memory.slotWords == 14 + 3 * planes.length, planes)
      for ((first, second) <- SetupWords.pairs)
        assert(memory.code(first) % 2 == 0 && memory.code(second) == memory.code(first) + 1)
    }
  }
}
