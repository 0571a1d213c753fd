package frustum.blackbox

/** What primitives a unit may instantiate. `Generic` infers everything and is what simulations run;
  * `Artix7` infers all but clock buffers. */
sealed trait Tech
object Tech {
  case object Generic extends Tech
  case object Ice40   extends Tech
  case object Artix7  extends Tech
}
