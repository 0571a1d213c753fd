package frustum.contract.video

/** A raster of pixels and its sync pulses: pixels and lines of the visible part, front porch, sync and back porch;
  * `hPositive`, `vPositive` are the pulses' polarity.
  */
case class VideoMode(
    name: String,
    pixelMHz: Double,
    width: Int,
    height: Int,
    hFront: Int,
    hSync: Int,
    hBack: Int,
    vFront: Int,
    vSync: Int,
    vBack: Int,
    hPositive: Boolean,
    vPositive: Boolean
) {
  require(width > 0 && height > 0, s"mode $name: $width x $height pixels")
  require(
    Seq(hFront, hSync, hBack, vFront, vSync, vBack).forall(_ > 0),
    s"mode $name: porches and pulses of $hFront $hSync $hBack x $vFront $vSync $vBack must be at least 1"
  )

  val hBlank: Int = hFront + hSync + hBack
  val vBlank: Int = vFront + vSync + vBack
  val hTotal: Int = width + hBlank
  val vTotal: Int = height + vBlank

  /** Clocks from the last visible pixel of a frame to the first of the next. */
  val blankClocks: Int = vBlank * hTotal + hBlank
}

object VideoMode {
  val Vga640x480 =
    VideoMode("640x480", 25.175, 640, 480, 16, 96, 48, 10, 2, 33, hPositive = false, vPositive = false)
  val Svga800x600 =
    VideoMode("800x600", 40.0, 800, 600, 40, 128, 88, 1, 4, 23, hPositive = true, vPositive = true)
}
