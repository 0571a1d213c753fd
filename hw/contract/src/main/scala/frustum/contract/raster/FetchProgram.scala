package frustum.contract.raster

import frustum.contract.Field
import SetupWords._

/** What is written into the set-up engine's scratch memory before its programs run, a row per word: a triangle's
  * vertices, and the small programs of [[FetchProgram.Corner]] and the others.
  */
object FetchProgram {

  /** Sources of a row's data, each with a bit of the row. `Scale` and `Power` are powers of two, all others minuends,
    * from which the word `origin` is subtracted. `Pixel` is a place in the tile, see [[Column]].
    */
  object Source extends Enumeration {
    val Position, Z, Q, Color, Texture, Area, Pixel, Scale, Power = Value

    /** Nothing is written. */
    val Skip = Value
  }

  // What a `Pixel` row has for its word: the tile's first or last column or line, or that of the first covered pixel.
  val Column = 0; val Line = 1
  val LastOf = 2; val CoveredOf = 4

  /** @param word   the current store word of the vertex
    * @param upper  the difference is written times 2^16
    * @param take   the store word's top byte is no longer needed
    */
  final case class Row(
      from: Source.Value,
      target: SetupWord = Nothing,
      origin: SetupWord = Nothing,
      word: Int = 0,
      upper: Boolean = false,
      take: Boolean = false
  )

  /** A field of a vertex and the word that its value, or what it has more than `origin`, goes to. */
  private final case class Load(
      field: Field,
      from: Source.Value,
      target: SetupWord,
      origin: SetupWord = Nothing,
      upper: Boolean = false
  ) {

    /** Bytes of the store word that come before it: fields are read where the word begins, and texture coordinates at
      * their place; of an exponent's word only the largest exponent of three is read.
      */
    def bytesBefore: Int = if (from == Source.Texture || from == Source.Scale) 0
    else {
      require((31 - field.slice.high) % 8 == 0, s"${field.name} does not begin at a byte")
      (31 - field.slice.high) / 8
    }
  }

  /** Rows of one vertex: vertex 0's fields, the others' differences. What vertex 0 leaves in a difference's place,
    * vertex 1 overwrites. Nothing is fetched of planes that are not needed.
    */
  def vertex(v: Int, planes: Seq[Int]): Seq[Row] = {
    val wanted = loads(v, planes)
    StoredVertex.fields.map(_.slice.word).distinct.flatMap { word =>
      val here = wanted.filter(_.field.slice.word == word)
      val ends = here.map(_.bytesBefore)
      def skips(n: Int) = Seq.fill(n)(Row(Source.Skip, word = word, take = true))
      val rows = here.zip(ends.drop(1) ++ ends.lastOption).zip(ends).flatMap { case ((load, next), now) =>
        val row = Row(load.from, load.target, load.origin, word, load.upper, take = next > now)
        row +: skips((next - now - 1).max(0))
      }
      skips(ends.headOption.getOrElse(0)) ++ rows
    }
  }

  /** The fields of vertex `v` that are needed. */
  private def loads(v: Int, planes: Seq[Int]): Seq[Load] = {
    import StoredVertex._
    def difference(of: SetupWord) = if (v == 0) Nothing else of
    def position(field: Field, targets: Seq[SetupWord], origin: SetupWord, upper: Boolean) =
      Load(field, Source.Position, targets(v), difference(origin), upper && v > 0)
    def plane(field: Field, from: Source.Value, p: Int) = Seq(p).filter(planes.contains).map(_ =>
      Load(field, from, Seq(value(p), delta1(p), delta2(p))(v), difference(value(p)))
    )
    def textured(load: Load) = Seq(load).filter(_ => planes.contains(PlaneQ))
    Seq(
      position(X, Seq(X0, DX1, DX2), X0, upper = false),
      position(X, Seq(DX1_16, DX1_16, DX2_16), X0, upper = true),
      position(Y, Seq(Y0, DY1_16, DY2_16), Y0, upper = true)
    ) ++ Seq(
      plane(Z, Source.Z, PlaneZ),
      textured(Load(QMantissa, Source.Q, q(v))),
      textured(Load(S, Source.Texture, s(v))),
      textured(Load(QExponent, Source.Scale, scale(v))),
      textured(Load(T, Source.Texture, t(v))),
      plane(R, Source.Color, PlaneR),
      plane(G, Source.Color, PlaneG),
      plane(B, Source.Color, PlaneB),
      plane(A, Source.Color, PlaneA)
    ).flatten
  }

  /** The walk's corners, relative to vertex 0. */
  val corner: Seq[Row] =
    Seq(
      Row(Source.Pixel, Left, X0, Column),
      Row(Source.Pixel, Right, X0, Column + LastOf),
      Row(Source.Pixel, Top, Y0, Line),
      Row(Source.Pixel, Bottom, Y0, Line + LastOf)
    )

  /** The first covered pixel, relative to vertex 0. */
  val pixel: Seq[Row] =
    Seq(
      Row(Source.Pixel, PixelX_16, X0, Column + CoveredOf, upper = true),
      Row(Source.Pixel, PixelY_16, Y0, Line + CoveredOf, upper = true)
    )

  /** The area normalised, and the shift that it took. */
  val normal: Seq[Row] = Seq(Row(Source.Area, AreaNormal), Row(Source.Power, Shift))

  val gradientShift: Seq[Row] = Seq(Row(Source.Power, Shift4))

  // Programs begin at these rows of the table; vertex v at 16 v.
  val Corner = 48; val Pixel = 52; val Normal = 56; val GradientShift = 60

  /** Rows from here on hold other things. */
  val Rows = 64

  /** Bits of a row: last 1, last of its store word 1, take 1, upper 1, word 3, a bit for each source but `Skip`, origin
    * 7, target 7.
    */
  val RowBits = 30

  private def encode(program: Seq[Row], memory: SetupMemory): Seq[Int] = program.zipWithIndex.map { case (r, n) =>
    val next = program.lift(n + 1)
    def bit(b: Boolean, at: Int) = (if (b) 1 else 0) << at
    val lastOfWord = r.from != Source.Pixel && next.forall(_.word != r.word)
    bit(next.isEmpty, 29) | bit(lastOfWord, 28) | bit(r.take, 27) | bit(r.upper, 26) | r.word << 23 |
      bit(r.from != Source.Skip, 14 + r.from.id) | memory.code(r.origin) << 7 | memory.code(r.target)
  }

  def image(planes: Seq[Int]): Seq[Int] = {
    val memory = SetupMemory(planes)
    val programs = (0 to 2).map(v => 16 * v -> vertex(v, planes)) ++
      Seq(Corner -> corner, Pixel -> pixel, Normal -> normal, GradientShift -> gradientShift)
    val rows = programs.flatMap { case (at, program) =>
      encode(program, memory).zipWithIndex.map { case (r, n) => at + n -> r }
    }.toMap
    require(rows.size == programs.map(_._2.length).sum, "programs of the table overlap")
    (0 until Rows).map(rows.getOrElse(_, 0))
  }
}
