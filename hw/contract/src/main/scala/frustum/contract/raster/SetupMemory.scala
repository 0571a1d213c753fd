package frustum.contract.raster

import SetupWord._

/** Places of the set-up's words in the scratch memory of [[SetupProgram]] and [[FetchProgram]] for these planes: those
  * of a triangle's slot one after the other, and among those that all slots share first the constants, then the others,
  * which share places where they are not needed at once.
  *
  * A word is needed from the step that writes it first to the one that reads it last, with everything between them, in
  * the order in which a triangle is set up and moved to a tile. A step's result is written after its operands were
  * read, and results are written in order, so that a word may take the place of one that the same step reads last.
  */
final case class SetupMemory(planes: Seq[Int]) {
  private val slot = SetupWords.all.filter(_.kind match {
    case Slot       => true
    case OfPlane(p) => planes.contains(p)
    case _          => false
  })
  private val constants = SetupWords.all.filter(_.kind.isInstanceOf[Constant])
  private val (setUp, move) = SetupMemory.steps(planes)
  private val lives = SetupMemory.lives(setUp, move)
  private val shared: Map[SetupWord, Int] = constants.zipWithIndex.toMap ++ allocate()
  private val slotPlace = slot.zipWithIndex.toMap

  /** Words of a slot, and those that all slots share. */
  val slotWords: Int = slot.length
  val sharedWords: Int = shared.values.max + 1
  require(slotWords.max(sharedWords) <= (1 << SetupMemory.CodeBits) / 2, s"$slotWords and $sharedWords words: too many")

  /** The code of a word in hardware: a flag for shared ones, then the place in the slot or among them. */
  def code(word: SetupWord): Int = slotPlace.getOrElse(
    word,
    1 << (SetupMemory.CodeBits - 1) | shared.getOrElse(
      word,
      throw new IllegalArgumentException(s"set-up of planes ${planes.mkString(", ")} has no word $word")
    )
  )

  /** What the shared words hold at first. */
  val initial: Seq[Int] = {
    val values = constants.map(w => shared(w) -> w.kind).collect { case (at, Constant(value)) => at -> value }.toMap
    (0 until sharedWords).map(values.getOrElse(_, 0))
  }

  /** Those that begin first are placed first, each in the lowest place that is free: for intervals this needs the
    * fewest places.
    */
  private def allocate(): Map[SetupWord, Int] = {
    final case class Group(words: Seq[SetupWord]) {
      val (from, to) = (words.map(lives(_)._1).min, words.map(lives(_)._2).max)
    }
    val paired = SetupWords.pairs.map { case (a, b) => Seq(a, b) }
    val groups =
      (paired ++ lives.keys.toSeq.diff(paired.flatten).sortBy(_.index).map(Seq(_))).map(Group(_)).sortBy(_.from)
    groups.foldLeft(Vector.empty[(Group, Int)]) { (placed, group) =>
      def free(place: Int) = placed.forall { case (other, at) =>
        other.to <= group.from || !(at until at + other.words.length).contains(place)
      }
      val size = group.words.length // 1, or 2: at an even place
      val place = Iterator.from(constants.length).filter(_ % size == 0).find(p => (p until p + size).forall(free)).get
      placed :+ (group -> place)
    }.flatMap { case (group, at) => group.words.zipWithIndex.map { case (w, i) => w -> (at + i) } }.toMap
  }
}

object SetupMemory {

  /** Bits of [[SetupMemory.code]]. */
  val CodeBits = 7

  /** Words that a step reads and writes. */
  private final case class Step(reads: Seq[SetupWord], writes: Seq[SetupWord])

  private def step(row: FetchProgram.Row): Step =
    if (row.from == FetchProgram.Source.Skip) Step(Nil, Nil) else Step(Seq(row.origin), Seq(row.target))

  private def step(i: SetupInstruction): Step = Step(
    Seq(i.a, i.b) ++ SetupWords.pairs.collect { case (first, second) if first eq i.a => second },
    i.result.word.toSeq
  )

  /** Steps of a set-up, and of a move to a tile. The gradients' steps come twice, as for a sliver. */
  private def steps(planes: Seq[Int]): (Seq[Step], Seq[Step]) = {
    val program = SetupProgram(planes)
    def vertices = (0 to 2).flatMap(FetchProgram.vertex(_, planes))
    def rows(r: FetchProgram.Row*) = r.map(step(_))
    def run(i: Seq[SetupInstruction]) = i.map(step(_))
    import FetchProgram._
    (
      rows(vertices: _*) ++ run(program.area) ++ rows(normal ++ gradientShift: _*) ++ run(program.attributes) ++
        run(program.steps) ++ rows(gradientShift: _*) ++ run(program.steps) ++ run(program.gradients),
      rows(corner: _*) ++ run(program.edges) ++ rows(pixel: _*) ++ run(program.rebase)
    )
  }

  /** First and last step of each shared word that is written. */
  private def lives(setUp: Seq[Step], move: Seq[Step]): Map[SetupWord, (Int, Int)] = {
    val all = (setUp ++ move).zipWithIndex
    val uses = all.flatMap { case (s, at) => s.writes.map(_ -> (at, true)) ++ s.reads.map(_ -> (at, false)) }
    uses.filter(_._1.kind == Shared).groupBy(_._1).map { case (word, own) =>
      val at = own.map(_._2)
      val (first, last) = (at.map(_._1).min, at.map(_._1).max)
      require(at.contains((first, true)) && !at.contains((first, false)), s"set-up: $word is read before it is written")
      require(last < setUp.length || first >= setUp.length, s"set-up: $word is needed later, but has no slot")
      word -> (first, last)
    }
  }
}
