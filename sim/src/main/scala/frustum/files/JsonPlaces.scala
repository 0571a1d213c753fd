package frustum.files

import scala.collection.mutable
import upickle.core.{ArrVisitor, ObjVisitor, Visitor}

/** A key that an object has twice, with the indices of both in the text. */
private case class JsonTwice(key: String, index: Int, first: Int) extends RuntimeException

/** Lists and objects within each other beyond [[JsonPlaces.MostDepth]]. */
private case class JsonDepth(index: Int) extends RuntimeException

/** Notes, while a JSON text is read, where its parts are: the index in the text of each value in a list and of each
  * key of an object.
  */
private final class JsonPlaces {
  import JsonPlaces._
  private val places = mutable.HashMap.empty[String, Int]

  /** The index of the part at a path, or of the nearest part around it. */
  @annotation.tailrec
  def of(path: String): Int = places.get(path) match {
    case Some(index)          => index
    case None if path.isEmpty => 0
    case None                 => of(path.take(path.lastIndexWhere(c => c == '.' || c == '[').max(0)))
  }

  /** What reads the value at a path as `ujson.Value` does. */
  def visitor(path: String, depth: Int = 0): Visitor[ujson.Value, ujson.Value] =
    new Visitor.Delegate[ujson.Value, ujson.Value](ujson.Value) {
      private def enter(index: Int): Unit = {
        if (depth == MostDepth) throw JsonDepth(index)
        places.getOrElseUpdate(path, index)
      }

      override def visitArray(length: Int, index: Int): ArrVisitor[ujson.Value, ujson.Value] = {
        enter(index)
        val inner = ujson.Value.visitArray(length, index)
        new ArrVisitor[ujson.Value, ujson.Value] {
          private var n = -1
          def subVisitor = { n += 1; visitor(s"$path[$n]", depth + 1) }
          def visitValue(v: ujson.Value, index: Int): Unit = {
            places.getOrElseUpdate(s"$path[$n]", index)
            inner.visitValue(v, index)
          }
          def visitEnd(index: Int): ujson.Value = inner.visitEnd(index)
        }
      }

      override def visitObject(length: Int, jsonableKeys: Boolean, index: Int): ObjVisitor[ujson.Value, ujson.Value] = {
        enter(index)
        val inner = ujson.Value.visitObject(length, jsonableKeys, index)
        new ObjVisitor[ujson.Value, ujson.Value] {
          private val keys = mutable.HashMap.empty[String, Int]
          private var key = ""
          private var at = 0
          def visitKey(index: Int): Visitor[_, _] = { at = index; inner.visitKey(index) }
          def visitKeyValue(v: Any): Unit = {
            key = v.toString
            keys.put(key, at).foreach(first => throw JsonTwice(key, at, first))
            places(if (path.isEmpty) key else s"$path.$key") = at
            inner.visitKeyValue(v)
          }
          def subVisitor = visitor(if (path.isEmpty) key else s"$path.$key", depth + 1)
          def visitValue(v: ujson.Value, index: Int): Unit = inner.visitValue(v, index)
          def visitEnd(index: Int): ujson.Value = inner.visitEnd(index)
        }
      }
    }
}

private object JsonPlaces {
  val MostDepth = 64
}
