package frustum.files

import frustum.contract.InputError
import frustum.driver.scene.Notice
import scala.collection.mutable

/** Collects and counts notices: an entry for each kind, in the order of the first of each. */
final class Notices {
  private val kinds = mutable.LinkedHashMap.empty[String, Notice]

  /** Counts a kind that is its own text. */
  def add(kind: String, times: Long = 1): Unit = count(kind, kind, times)

  /** Counts one at a place of a file; the text of the first of a kind is kept. */
  def at(place: String, what: String, kind: String): Unit = count(kind, s"$place: $what", 1)
  def at(place: String, what: String): Unit = at(place, what, what)

  private def count(kind: String, what: String, times: Long): Unit =
    if (times > 0) kinds(kind) = kinds.get(kind).fold(Notice(what, times))(n => n.copy(count = n.count + times))

  def result: IndexedSeq[Notice] = kinds.values.toIndexedSeq
  def lines: Seq[String] = result.map(_.toString)
  def print(): Unit = Notices.print(result)
}

object Notices {

  /** A line each on stderr. */
  def print(notices: Seq[Notice]): Unit = notices.foreach(notice => Console.err.println(notice))

  /** InputError of the first, and how many more there are, for those who take none. */
  def refuse(notices: Seq[Notice]): Unit = notices.headOption.foreach { first =>
    val more = if (notices.length > 1) s" (and ${notices.length - 1} more kinds of notice)" else ""
    throw InputError(s"${first.what}$more; --strict makes an error of it: leave --strict out or mend the file")
  }

  def json(notices: Seq[Notice]): ujson.Arr =
    ujson.Arr.from(notices.map(n => ujson.Obj("what" -> n.what, "count" -> n.count.toDouble)))
}
