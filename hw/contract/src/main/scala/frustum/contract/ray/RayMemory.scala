package frustum.contract.ray

import scala.collection.mutable

/** Places for the words of a [[RayProgramBuilder]]: those in `first` from 0 on, then what keeps its value from frame to
  * frame or from row to row, then the rest, which share places when they are not needed at once.
  *
  * @param inputs written before each frame's steps
  */
class RayMemory(b: RayProgramBuilder, first: Seq[RayWord], inputs: Seq[RayWord]) {
  private val places = mutable.LinkedHashMap[RayWord, Int]()
  private var used = 0
  private def fresh(): Int = { used += 1; used - 1 }

  private val read = b.frame.zipWithIndex.flatMap { case (s, t) => Seq(s.a -> t, s.b -> t) }
  private val last = read.toMap // the last pair of a word wins
  private val kept = (first ++ b.row.flatMap(s => Seq(s.to, s.a, s.b)) ++
    b.frame.flatMap(s => Seq(s.a, s.b)).filter(_.constant.isDefined)).distinct
  kept.foreach(w => places(w) = fresh())

  private val free = mutable.SortedSet[Int]()
  private def place(w: RayWord): Unit = if (!places.contains(w)) {
    places(w) = free.headOption.fold(fresh()) { p => free -= p; p }
  }
  private val keeps = kept.toSet
  inputs.foreach(place)
  for ((s, t) <- b.frame.zipWithIndex) {
    // A multiplication writes its result while it reads its operands: it has a place of its own.
    val done = Seq(s.a, s.b).distinct.filter(w => last(w) == t && !keeps(w))
    if (s.op == RayStep.Multiply) place(s.to)
    done.foreach(w => free += places(w))
    place(s.to)
    if (!last.contains(s.to) && !keeps(s.to)) free += places(s.to)
  }

  val size: Int = used
  val constants: Map[Int, BigInt] =
    places.collect { case (w, p) if w.constant.isDefined => p -> w.constant.get }.toMap
  def apply(w: RayWord): Int = places(w)
  def step(o: RayOperation): RayStep =
    RayStep(o.op, places(o.to), places(o.a), places(o.b), o.b.range.width, o.to.range)
}
