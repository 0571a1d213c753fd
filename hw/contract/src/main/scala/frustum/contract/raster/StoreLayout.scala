package frustum.contract.raster

/** Addresses in the scene store, in 32-bit words. The store has two banks: one is filled while the other is drawn.
  *
  * An address is concatenated from the bits of an index and of a word's number, without an adder.
  *
  * @param stored layout of a render state; tests use longer ones
  */
final case class StoreLayout(config: RasterConfig, stored: StoredStateLayout = StoredState) {
  val vertexWords: Int = StoredVertex.words
  val triangleWords: Int = StoredTriangle.words
  val stateWords: Int = stored.words
  private val stateBits = 31 - Integer.numberOfLeadingZeros(RenderState.Count)
  val states: Int = aligned(vertexWords << config.vertexBits, powerOfTwo(stateWords) << stateBits)
  val triangles: Int = aligned(states + (stateWords << stateBits), triangleWords << config.triangleBits)
  val bankWords: Int = triangles + triangleWords * config.maxTriangles
  val addressBits: Int = 1 + bankAddressBits
  def bankAddressBits: Int = 32 - Integer.numberOfLeadingZeros(bankWords - 1)
  require(triangleWords == powerOfTwo(triangleWords), s"a triangle has $triangleWords words, not a power of two")

  /** The addresses of the words of a [[StoredVertex]], a [[StoredTriangle]] and a [[StoredState]]. */
  def vertex(index: Int, word: Int): Int = word << config.vertexBits | index
  def state(index: Int, word: Int): Int = states | word << stateBits | index
  def triangle(index: Int, word: Int): Int = triangles | triangleWords * index | word

  /** The bits of fields in the word at an address. */
  def mask(address: Int): Int =
    if (address >= triangles) StoredTriangle.mask((address - triangles) % triangleWords)
    else if (address >= states) stored.mask(address - states >> stateBits)
    else StoredVertex.mask(address >> config.vertexBits)

  private def powerOfTwo(n: Int) = if (n == 1) 1 else 1 << (32 - Integer.numberOfLeadingZeros(n - 1))
  private def aligned(from: Int, unit: Int) = (from + unit - 1) / unit * unit
}
