package frustum.play

/** Where a played system's picture goes, and where keys and mouse come from. */
trait PlayScreen extends AutoCloseable {
  def isOpen: Boolean

  /** Keys down, by their `KeyEvent` codes; see [[PressedKeys]]. */
  def keys(): Set[Int]

  /** What the mouse did since it was last asked for. */
  def pointer(): PointerMoves = PointerMoves()

  /** @param rgb 0xRRGGBB, row by row
    * @param state what the title tells beside name and frame rate
    */
  def show(rgb: Array[Int], state: String = ""): Unit

  def framesPerSecond: Double
  def close(): Unit = ()
}
