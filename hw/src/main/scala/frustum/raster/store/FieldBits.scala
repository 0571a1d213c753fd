package frustum.raster.store

import frustum.contract.Field
import spinal.core._
import spinal.lib._

/** The bits of a layout's fields in hardware: `import FieldBits._`, then `StoredVertex.X.in(word)`. */
object FieldBits {
  implicit class InWords(field: Field) {

    /** Read from the word that holds all of the field. */
    def in(word: Bits): Bits = word(field.slice.high downto field.slice.low)

    /** Puts a value into the word that holds all of the field, over what the word has there. */
    def put(word: Bits, value: Bits): Unit = word(field.slice.high downto field.slice.low) := value
  }

  /** Fields that are adjacent in one word, the most significant first: `value` into all of them at once. */
  def putAll(fields: Seq[Field], word: Bits, value: Bits): Unit = {
    val slices = fields.map(_.slice)
    require(
      slices.zip(slices.tail).forall { case (a, b) => a.word == b.word && a.low == b.high + 1 },
      s"${fields.map(_.name).mkString(", ")} are not adjacent"
    )
    word(slices.head.high downto slices.last.low) := value
  }
}
