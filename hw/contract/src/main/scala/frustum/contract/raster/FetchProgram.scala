package frustum.contract.raster

import SetupWords._

/** What is written into the set-up engine's scratch memory before its programs run, a row a word: a triangle's vertices,
  * and the small programs of [[FetchProgram.Corner]] and the others.
  */
object FetchProgram {

  /** Where a row's data comes from, a bit of the row each. `Scale` and `Power` are powers of two, all others minuends, from
    * which the word `origin` is subtracted. `Pixel` is a place in the tile, see [[Column]].
    */
  object Field extends Enumeration {
    val Position, Z, Q, Color, Texture, Area, Pixel, Scale, Power = Value

    /** Nothing is written. */
    val Skip = Value
  }

  // What a `Pixel` row has for its word: the tile's first or last column or line, or that of the first covered pixel.
  val Column = 0; val Line = 1
  val LastOf = 2; val CoveredOf = 4

  /** @param word   which of the vertex's store words holds the field; it stands at the word's top, except for
    *               texture coordinates
    * @param upper  the difference is written times 2^16
    * @param take   the store word's top byte is done with
    */
  final case class Row(
      field: Field.Value,
      target: Int = Nothing,
      origin: Int = Nothing,
      word: Int = 0,
      upper: Boolean = false,
      take: Boolean = false
  )

  private def position(vertex: Int, targets: Seq[Int], take: Boolean, origin: Int, upper: Boolean) =
    Row(Field.Position, targets(vertex), if (vertex == 0) Nothing else origin, 0, upper && vertex > 0, take)

  private def plane(vertex: Int, word: Int, field: Field.Value, p: Int) =
    Row(
      field,
      Seq(value(p), delta1(p), delta2(p))(vertex),
      if (vertex == 0) Nothing else value(p),
      word,
      take = true
    )

  /** Rows of one vertex: vertex 0's fields, the others' differences. What vertex 0 leaves in a difference's place, vertex 1
    * overwrites. Of planes that are not wanted nothing is fetched.
    */
  def vertex(v: Int, planes: Seq[Int]): Seq[Row] = {
    val rows = fields(v)
    rows.zipWithIndex.collect {
      case (row, _) if wanted(row, planes)                                                               => row
      case (row, n) if row.take && rows.drop(n + 1).exists(r => r.word == row.word && wanted(r, planes)) =>
        Row(Field.Skip, word = row.word, take = true)
    }
  }

  private def wanted(row: Row, planes: Seq[Int]): Boolean = row.field match {
    case Field.Q | Field.Texture | Field.Scale => planes.contains(PlaneQ)
    case Field.Z                               => planes.contains(PlaneZ)
    case Field.Color => planes.exists(p => Seq(value(p), delta1(p), delta2(p)).contains(row.target))
    case Field.Skip  => false
    case _           => true
  }

  private def fields(v: Int): Seq[Row] = Seq(
    position(v, Seq(X0, DX1, DX2), take = false, X0, upper = false),
    position(v, Seq(DX1_16, DX1_16, DX2_16), take = true, X0, upper = true),
    Row(Field.Skip, word = 0, take = true),
    position(v, Seq(Y0, DY1_16, DY2_16), take = false, Y0, upper = true),
    plane(v, 1, Field.Z, PlaneZ),
    Row(Field.Skip, word = 1, take = true),
    Row(Field.Q, q(v), word = 1),
    Row(Field.Texture, s(v), word = ExponentWord),
    Row(Field.Scale, scale(v), word = ExponentWord),
    Row(Field.Texture, t(v), word = 3),
    plane(v, 4, Field.Color, PlaneR),
    plane(v, 4, Field.Color, PlaneG),
    plane(v, 4, Field.Color, PlaneB),
    plane(v, 4, Field.Color, PlaneA)
  )

  /** The store word with a vertex's exponent, in its upper five bits. */
  val ExponentWord = 2

  /** The walk's corners, relative to vertex 0. */
  val corner: Seq[Row] =
    Seq(
      Row(Field.Pixel, Left, X0, Column),
      Row(Field.Pixel, Right, X0, Column + LastOf),
      Row(Field.Pixel, Top, Y0, Line),
      Row(Field.Pixel, Bottom, Y0, Line + LastOf)
    )

  /** The first covered pixel, relative to vertex 0. */
  val pixel: Seq[Row] =
    Seq(
      Row(Field.Pixel, PixelX_16, X0, Column + CoveredOf, upper = true),
      Row(Field.Pixel, PixelY_16, Y0, Line + CoveredOf, upper = true)
    )

  /** The area normalised, and the shift that it took. */
  val normal: Seq[Row] = Seq(Row(Field.Area, AreaNormal), Row(Field.Power, Shift))

  val gradientShift: Seq[Row] = Seq(Row(Field.Power, Shift4))

  // Programs begin at these rows of the table; vertex v at 16 v.
  val Corner = 48; val Pixel = 52; val Normal = 56; val GradientShift = 60

  /** Rows from here on hold other things. */
  val Rows = 64

  /** Bits of a row: last 1, last of its store word 1, take 1, upper 1, word 3, a bit for each field but `Skip`, origin 7,
    * target 7.
    */
  val RowBits = 30

  private def encode(program: Seq[Row], planes: Seq[Int]): Seq[Int] = program.zipWithIndex.map { case (r, n) =>
    val next = program.lift(n + 1)
    def bit(b: Boolean, at: Int) = (if (b) 1 else 0) << at
    val lastOfWord = r.field != Field.Pixel && next.forall(_.word != r.word)
    bit(next.isEmpty, 29) | bit(lastOfWord, 28) | bit(r.take, 27) | bit(r.upper, 26) | r.word << 23 |
      bit(r.field != Field.Skip, 14 + r.field.id) | code(r.origin, planes) << 7 | code(r.target, planes)
  }

  def image(planes: Seq[Int]): Seq[Int] = {
    val programs = (0 to 2).map(v => 16 * v -> vertex(v, planes)) ++
      Seq(Corner -> corner, Pixel -> pixel, Normal -> normal, GradientShift -> gradientShift)
    val rows = programs.flatMap { case (at, program) =>
      encode(program, planes).zipWithIndex.map { case (r, n) => at + n -> r }
    }.toMap
    require(rows.size == programs.map(_._2.length).sum, "programs of the table overlap")
    (0 until Rows).map(rows.getOrElse(_, 0))
  }
}
