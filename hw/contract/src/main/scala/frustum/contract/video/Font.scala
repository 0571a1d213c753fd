package frustum.contract.video

/** Letters of 5 x 7 dots in cells of 8 x 8, for text on a display: code = ASCII - 32, 0 to 63. */
object Font {
  val CodeBits = 6
  val Cell = 8

  /** Rows from the top, five dots each, the leftmost in the highest bit. */
  private val glyphs: Map[Char, String] = Map(
    '0' -> "0E 11 13 15 19 11 0E",
    '1' -> "04 0C 04 04 04 04 0E",
    '2' -> "0E 11 01 02 04 08 1F",
    '3' -> "1F 02 04 02 01 11 0E",
    '4' -> "02 06 0A 12 1F 02 02",
    '5' -> "1F 10 1E 01 01 11 0E",
    '6' -> "06 08 10 1E 11 11 0E",
    '7' -> "1F 01 02 04 08 08 08",
    '8' -> "0E 11 11 0E 11 11 0E",
    '9' -> "0E 11 11 0F 01 02 0C",
    'A' -> "0E 11 11 1F 11 11 11",
    'B' -> "1E 11 11 1E 11 11 1E",
    'C' -> "0E 11 10 10 10 11 0E",
    'D' -> "1C 12 11 11 11 12 1C",
    'E' -> "1F 10 10 1E 10 10 1F",
    'F' -> "1F 10 10 1E 10 10 10",
    'G' -> "0E 11 10 17 11 11 0F",
    'H' -> "11 11 11 1F 11 11 11",
    'I' -> "0E 04 04 04 04 04 0E",
    'J' -> "07 02 02 02 02 12 0C",
    'K' -> "11 12 14 18 14 12 11",
    'L' -> "10 10 10 10 10 10 1F",
    'M' -> "11 1B 15 15 11 11 11",
    'N' -> "11 11 19 15 13 11 11",
    'O' -> "0E 11 11 11 11 11 0E",
    'P' -> "1E 11 11 1E 10 10 10",
    'Q' -> "0E 11 11 11 15 12 0D",
    'R' -> "1E 11 11 1E 14 12 11",
    'S' -> "0F 10 10 0E 01 01 1E",
    'T' -> "1F 04 04 04 04 04 04",
    'U' -> "11 11 11 11 11 11 0E",
    'V' -> "11 11 11 11 11 0A 04",
    'W' -> "11 11 11 15 15 15 0A",
    'X' -> "11 11 0A 04 0A 11 11",
    'Y' -> "11 11 11 0A 04 04 04",
    'Z' -> "1F 01 02 04 08 10 1F",
    '.' -> "00 00 00 00 00 0C 0C",
    ':' -> "00 0C 0C 00 0C 0C 00",
    '-' -> "00 00 00 1F 00 00 00",
    '/' -> "00 01 02 04 08 10 00",
    '!' -> "04 04 04 04 04 00 04",
    '%' -> "18 19 02 04 08 13 03"
  )

  def has(c: Char): Boolean = c == ' ' || glyphs.contains(c)

  /** Code of a letter; a character without a glyph is refused. */
  def code(c: Char): Int = {
    require(has(c), s"the font has no '$c'")
    c - 32
  }

  /** Dots of a row of a cell, the leftmost in bit 7; the cell's first column and last row are empty. */
  def row(code: Int, y: Int): Int =
    glyphs.get((code + 32).toChar).filter(_ => y < 7).fold(0)(g => Integer.parseInt(g.split(' ')(y), 16) << 2)

  /** Row y of letter c at 8 c + y. */
  def table: Seq[Int] = Seq.tabulate(1 << CodeBits, Cell)(row).flatten
}
