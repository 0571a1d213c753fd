package frustum.play

import org.scalatest.funsuite.AnyFunSuite

/** The window itself, on a virtual display. */
class LiveScreenWindowTest extends AnyFunSuite {
  test("picture, keys without a window manager, mouse, frame rate and closing") {
    assume(VirtualDisplay.isThere, VirtualDisplay.missing)
    val said = VirtualDisplay.run("frustum.play.LiveScreenProbe", 60)
    assert(
      said.linesIterator.toSeq == Seq(
        "picture true",
        "pressed true",
        "released true",
        "dragged true",
        "wheel true",
        "rate true",
        "closed true"
      )
    )
  }
}
