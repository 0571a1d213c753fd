package frustum.command.chart

import frustum.contract.InputError

/** The names that a mistyped one may stand for. */
object NearestName {

  /** Single letters put in, left out, changed or exchanged with their neighbour that make one of the other (Damerau
    * 1964).
    */
  def distance(a: String, b: String): Int = {
    val d = Array.tabulate(a.length + 1, b.length + 1)((i, j) => if (i == 0) j else if (j == 0) i else 0)
    for (i <- 1 to a.length; j <- 1 to b.length) {
      val change = if (a(i - 1) == b(j - 1)) 0 else 1
      d(i)(j) = (d(i - 1)(j) + 1).min(d(i)(j - 1) + 1).min(d(i - 1)(j - 1) + change)
      if (i > 1 && j > 1 && a(i - 1) == b(j - 2) && a(i - 2) == b(j - 1)) d(i)(j) = d(i)(j).min(d(i - 2)(j - 2) + 1)
    }
    d(a.length)(b.length)
  }

  /** At most three, the nearest first; none where all are far. */
  def of(mistyped: String, names: Seq[String]): Seq[String] =
    names.map(n => n -> distance(mistyped, n)).filter { case (n, d) => d <= 1 + n.length / 3 }.sortBy(
      _._2
    ).take(3).map(_._1)

  def unknown(argument: String, mistyped: String, names: Seq[String]): InputError = {
    val near = of(mistyped, names)
    val meant = if (near.isEmpty) "" else s"did you mean ${near.mkString(" or ")}? There are "
    InputError(s"argument $argument: '$mistyped' is no name of a chart; $meant${names.mkString(", ")}")
  }
}
