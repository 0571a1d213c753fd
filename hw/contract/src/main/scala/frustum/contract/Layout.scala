package frustum.contract

import scala.collection.mutable.ArrayBuffer

/** The places of a record's fields in words of `wordBits` bits: a table of [[Field]]s, from which encoders, decoders,
  * hardware and documentation are made. Bits of no field are spare: encoded as 0 and ignored when read.
  *
  * A word is held in an Int as its bit pattern, so that one of 32 bits may be negative.
  *
  * @param name of the record, for messages and headings
  */
abstract class Layout(val name: String, val wordBits: Int) {
  require(wordBits >= 1 && wordBits <= 32, s"$name: words of $wordBits bits, 1..32")
  private val table = ArrayBuffer.empty[Field]

  /** All fields, in the order of the table. */
  def fields: Seq[Field] = table.toSeq

  /** Words that the fields need. */
  def words: Int = fields.flatMap(_.slices).map(_.word).max + 1

  /** The field of this name. */
  def apply(field: String): Field = fields.find(_.name == field).getOrElse(
    throw new IllegalArgumentException(s"$name has no field '$field'; it has ${fields.map(_.name).mkString(", ")}")
  )

  /** The bits of word `word` that belong to a field. */
  def mask(word: Int): Int = fields.flatMap(_.slices).filter(_.word == word).foldLeft(0)(_ | _.mask)

  /** The words of a record; every field must be given once, with a value that it can hold. */
  def encode(values: (Field, Int)*): IndexedSeq[Int] = {
    require(
      values.length == table.length && fields.forall(f => values.exists(_._1 == f)),
      s"$name: values for ${values.map(_._1.name).mkString(", ")}, needs ${fields.map(_.name).mkString(", ")}"
    )
    for ((f, v) <- values) require(f.fits(v), s"$name: $v is outside ${f.least}..${f.greatest} of ${f.name}")
    val encoded = new Array[Int](words)
    for ((f, v) <- values; (word, bits) <- f.placed(v)) encoded(word) |= bits
    encoded.toIndexedSeq
  }

  protected def unsigned(name: String, at: Seq[Slice], meaning: String): Field =
    add(Field(name, at, signed = false, meaning))
  protected def signed(name: String, at: Seq[Slice], meaning: String): Field =
    add(Field(name, at, signed = true, meaning))

  /** A field described elsewhere. */
  protected def add(field: Field): Field = {
    require(!table.exists(_.name == field.name), s"$name: two fields are called ${field.name}")
    for (s <- field.slices) {
      require(s.low >= 0 && s.high < wordBits && s.low <= s.high, s"$name: ${field.name} has bits ${s.high}..${s.low}")
      require((mask(s.word) & s.mask) == 0, s"$name: ${field.name} overlaps another field in word ${s.word}")
    }
    table += field
    field
  }

  /** All of a word, or some bits of it, the most significant one first. */
  protected def word(n: Int): Seq[Slice] = Seq(Slice(n, wordBits - 1, 0))
  protected def bits(word: Int, high: Int, low: Int): Seq[Slice] = Seq(Slice(word, high, low))
  protected def bit(word: Int, n: Int): Seq[Slice] = bits(word, n, n)
}
