package frustum.contract.raster

import frustum.contract.Field

/** Bits of a field that are constant.
  *
  * @param mask  the bits, @param value their values, 0 elsewhere
  */
final case class FixedBits(mask: Int, value: Int) {
  require((value & ~mask) == 0, s"fixed bits: value $value has bits outside its mask $mask")
}

/** The bits of a [[RenderState]] that are constant in hardware, so that nothing is built for what no state of a scene
  * uses. States that differ in such a bit are refused.
  *
  * @param constants by the name of a field of [[RenderStateLayout]]; fields without a constant bit are not among them
  */
final case class FixedState(constants: Map[String, FixedBits]) {
  import RenderStateLayout._
  for ((name, bits) <- constants) require(
    bits.mask != 0 && (bits.mask & ~RenderStateLayout(name).ones) == 0,
    s"fixed state: mask ${bits.mask} of $name, which has ${RenderStateLayout(name).width} bits"
  )

  /** The constant bits of a field. */
  def apply(field: Field): FixedBits = constants.getOrElse(field.name, FixedBits(0, 0))

  /** With some bits of a field constant as well. */
  def bits(field: String, mask: Int, value: Int): FixedState =
    FixedState(constants + (field -> FixedBits(mask, value)))

  private def isConstant(field: Field): Boolean = apply(field).mask == field.ones
  private def is(field: Field, value: Int): Boolean = apply(field) == FixedBits(field.ones, value)
  private def differs(words: Seq[Int])(field: Field) = ((field.of(words) ^ apply(field).value) & apply(field).mask) != 0

  /** The features that are constant, none of whose bits can be chosen. */
  def constant: Seq[String] = FixedState.features.collect { case (name, fields) if fields.forall(isConstant) => name }

  /** With one of these features to be chosen again. */
  def without(feature: String): FixedState =
    FixedState(constants -- FixedState.features.toMap.apply(feature).map(_.name))

  /** Attribute planes that some state uses. */
  def planes: Seq[Int] = {
    import SetupWords._
    val none = Seq(
      is(CombineMode, Combine.ColorOnly.code) -> Seq(PlaneS, PlaneT, PlaneQ),
      is(CombineMode, Combine.Replace.code) -> Seq(PlaneR, PlaneG, PlaneB),
      is(DepthTest, DepthFunction.Always.code) -> Seq(PlaneZ),
      (neverBlends && is(AlphaRef, 0)) -> Seq(PlaneA)
    ).collect { case (true, planes) => planes }.flatten
    AllPlanes.diff(none)
  }

  /** Nothing can be chosen: there is one state, which is not stored. */
  def whole: Boolean = fields.forall(isConstant)

  /** All states show the texel unchanged and none uses alpha. */
  def texelsAlone: Boolean = is(CombineMode, Combine.Replace.code) && !planes.contains(SetupWords.PlaneA)

  /** Whether a fragment passes does not depend on the tile's memories. */
  def neverReads: Boolean = neverBlends && !planes.contains(SetupWords.PlaneZ)

  /** No state blends. */
  def neverBlends: Boolean = is(Blend, 0)

  /** Whether the hardware takes a state of these words of the wire. */
  def accepts(words: Seq[Int], layout: StateLayout = RenderStateLayout): Boolean =
    !layout.fields.exists(differs(words))

  /** Why the hardware cannot draw with a state, or None. */
  def fault(s: RenderState): Option[String] = {
    val wanting = FixedState.features.collect { case (name, fields) if fields.exists(differs(s.words)) => name }
    if (wanting.isEmpty) None else Some("needs another " + wanting.mkString(", "))
  }

  /** As the code that makes it. */
  def code: String = {
    val (whole, partly) = fields.filter(f => constants.contains(f.name)).partition(isConstant)
    val parts = partly.map(f => s""".bits("${f.name}", mask = ${apply(f).mask}, value = ${apply(f).value})""")
    val first = whole.map(f => s""""${f.name}" -> ${apply(f).value}""")
    (if (first.isEmpty) "FixedState.None" else first.mkString("FixedState.fields(", ", ", ")")) + parts.mkString
  }
}

object FixedState {
  import RenderStateLayout._

  /** Everything can be chosen. */
  val None: FixedState = FixedState(Map.empty[String, FixedBits])

  /** These fields have these values always. */
  def fields(values: (String, Int)*): FixedState =
    FixedState(values.map { case (name, value) => name -> FixedBits(RenderStateLayout(name).ones, value) }.toMap)

  /** The bits that are equal in these states. */
  def of(states: RenderState*): FixedState = {
    require(states.nonEmpty, "FixedState: of no states")
    val words = states.map(_.words)
    val agreed = for {
      field <- RenderStateLayout.fields
      values = words.map(field.of)
      mask = field.ones & ~values.map(_ ^ values.head).reduce(_ | _)
      if mask != 0
    } yield field.name -> FixedBits(mask, values.head & mask)
    FixedState(agreed.toMap)
  }

  /** What users call the fields. */
  private val features = Seq(
    "texture address" -> Seq(TextureBase),
    "texture size" -> Seq(Log2Width, Log2Height),
    "texel format" -> Seq(Format),
    "wrap" -> Seq(WrapS, WrapT),
    "combine" -> Seq(CombineMode),
    "depth function" -> Seq(DepthTest, DepthWrite),
    "blending" -> Seq(Blend),
    "alpha test" -> Seq(AlphaRef)
  )
}
