package frustum.device

/** What primitives a unit may instantiate. */
sealed trait Tech
object Tech {

  /** Memories, adders and multipliers are left to the tools to infer. */
  sealed trait Inferred extends Tech

  /** Nothing of a vendor's: what simulations run. */
  case object Generic extends Inferred

  /** Clock buffers of the Artix-7. */
  case object Artix7 extends Inferred

  /** Cells of the iCE40 UltraPlus. */
  case object Ice40 extends Tech
}
