package frustum.model.bus

import scala.collection.mutable

/** What [[frustum.bus.CommitFifo]] holds, without its timing. */
final class CommitFifo {
  private val visible = mutable.Queue.empty[Int]
  private val speculative = mutable.Queue.empty[Int]

  def held: Int = visible.size + speculative.size
  def readable: Int = visible.size

  def push(word: Int): Unit = speculative += word
  def commit(): Unit = { visible ++= speculative; speculative.clear() }
  def rollback(): Unit = speculative.clear()
  def pop(): Int = visible.dequeue()
}
