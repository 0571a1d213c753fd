package frustum.contract.raster

/** How many adders the edge walker has; the spans are the same. */
sealed trait WalkerKind

object WalkerKind {

  /** One, which the three edges use in turn: the smaller. */
  case object Serial extends WalkerKind

  /** One for each edge: all three move at once. */
  case object Parallel extends WalkerKind
}
