package frustum.contract.raster

/** Bits of the 32-bit word of a [[RenderState]] that hardware holds constant, so that nothing is built for what no state of a
  * scene asks for. States that differ in such a bit are refused.
  *
  * @param mask  the bits, @param value their values, 0 elsewhere
  */
final case class FixedState(mask: Int, value: Int) {
  require((value & ~mask) == 0, f"FixedState: value $value%08x has bits outside of its mask $mask%08x")

  /** The fields that are constant, none of whose bits can be chosen. */
  def constant: Seq[String] = FixedState.fields.collect { case (name, bits) if (mask & bits) == bits => name }

  /** With one of these fields to be chosen again. */
  def without(field: String): FixedState = {
    val bits = FixedState.fields.toMap.apply(field)
    FixedState(mask & ~bits, value & ~bits)
  }

  /** Attribute planes that some state can make a difference with. */
  def planes: Seq[Int] = {
    import SetupWords._
    def is(bits: Int, constant: Int) = (mask & bits) == bits && (this.value & bits) == constant
    val none = Seq(
      is(FixedState.CombineBits, Combine.ColorOnly.code << 20) -> Seq(PlaneS, PlaneT, PlaneQ),
      is(FixedState.CombineBits, Combine.Replace.code << 20) -> Seq(PlaneR, PlaneG, PlaneB),
      is(FixedState.Functions, DepthFunction.Always.code << 22) -> Seq(PlaneZ),
      (neverBlends && is(FixedState.AlphaRef, 0)) -> Seq(PlaneA)
    ).collect { case (true, planes) => planes }.flatten
    AllPlanes.diff(none)
  }

  /** Nothing can be chosen: there is one state, and no need to keep it. */
  def whole: Boolean = mask == -1

  /** All states show the texel as it is, and nobody asks for its alpha. */
  def texelsAlone: Boolean =
    (mask & FixedState.CombineBits) == FixedState.CombineBits &&
      (value & FixedState.CombineBits) == Combine.Replace.code << 20 && !planes.contains(SetupWords.PlaneA)

  /** No fragment's fate depends on what is in the tile's memories. */
  def neverReads: Boolean = neverBlends && !planes.contains(SetupWords.PlaneZ)

  /** No state blends. */
  def neverBlends: Boolean = (mask & FixedState.Blend) != 0 && (value & FixedState.Blend) == 0

  /** What keeps the hardware from drawing with a state, or None. */
  def fault(s: RenderState): Option[String] = {
    val differs = (FixedState.word(s) ^ value) & mask
    val names = FixedState.fields.collect { case (name, bits) if (differs & bits) != 0 => name }
    if (differs == 0) None else Some("needs another " + names.mkString(", "))
  }
}

object FixedState {

  /** Everything can be chosen. */
  val None: FixedState = FixedState(0, 0)

  /** What these states agree in. */
  def of(states: RenderState*): FixedState = {
    require(states.nonEmpty, "FixedState: of no states")
    val words = states.map(word)
    val mask = words.map(w => ~(w ^ words.head)).reduce(_ & _)
    FixedState(mask, words.head & mask)
  }

  /** As `frustum.raster.store.RenderStateWord` has it: the second word of the wire in the upper half. */
  def word(s: RenderState): Int = s.words(1) << 16 | s.words(0)

  private val CombineBits = 3 << 20
  private val Functions = 7 << 22
  private val Blend = 1 << 26
  private val AlphaRef = 31 << 27

  private val fields = Seq(
    "texture address" -> 0x1ff,
    "texture size" -> (63 << 9),
    "texel format" -> (1 << 15),
    "wrap" -> (15 << 16),
    "combine" -> CombineBits,
    "depth function" -> (15 << 22),
    "blending" -> Blend,
    "alpha test" -> AlphaRef
  )
}
