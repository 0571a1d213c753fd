package frustum.budgets

/** What a bounded figure is called for readers.
  *
  * @param key  its name in `sim/budgets.json`
  * @param unit empty where it is a plain number
  */
final case class Metric(key: String, name: String, unit: String)

object Metric {
  private val Picture = Seq(
    ("primitiveWrong", "another triangle shows", "pixels"),
    ("texelsWrong", "another texel is read", "texels"),
    ("primitiveUnexplained", "another triangle shows, and rounding does not account for it", "pixels"),
    ("texelsUnexplained", "another texel is read, and rounding does not account for it", "texels"),
    ("unexplainedPercent", "pixels whose difference rounding does not account for", "% of those judged"),
    ("colorWrong", "the right texel in another colour", "pixels"),
    ("coverageWrong", "covered wrongly: missing, too many or drawn twice", "pixels"),
    ("texelsWrongByMoreThanOne", "a texel is read that is not a neighbour of the right one", "texels"),
    ("maxTexelError", "greatest distance from the right texel", "texels"),
    ("depthOrderWrong", "a triangle shows that lies behind the right one", "pixels"),
    ("psnr", "signal-to-noise ratio of the picture", "dB"),
    ("flip", "FLIP: how different the pictures look, 0 to 1", ""),
    ("swimRms", "texture's crawl from picture to picture, root mean square", "texels"),
    ("swimMost", "texture's crawl from picture to picture, greatest", "texels"),
    ("popsPercent", "fragments whose texture jumps by half a texel or more", "%")
  )

  /** Who is compared with whom. */
  private val Groups = Seq(
    "modelVsReference" -> "hardware against exact arithmetic",
    "snapping" -> "rounded vertices against unrounded ones",
    "temporal" -> "while the view pans",
    "endToEnd" -> "picture against the referee"
  )

  private val Others = Seq(
    Metric("silhouettePixelsWrong", "on the wrong side of a silhouette", "pixels"),
    Metric("shadowPixelsWrong", "on the wrong side of a shadow's edge", "pixels"),
    Metric("objectPixelsWrong", "another object shows", "pixels"),
    Metric("checkerCellsWrong", "another cell of the checker shows", "pixels"),
    Metric("maxColourError", "greatest error of a colour", "of 255"),
    Metric("psnr", "signal-to-noise ratio of the picture", "dB"),
    Metric("blocksWrong", "another block is seen", "rays"),
    Metric("facesWrong", "another face is seen", "rays"),
    Metric("texelsWrong", "another texel is seen", "rays"),
    Metric("maxDirectionErrorPixels", "greatest error of a ray's direction", "pixels"),
    Metric("steps", "words of the world's memory read, leaps as distances by octants", "words"),
    Metric("steps.quadrants", "words of the world's memory read, leaps as distances by quadrants", "words"),
    Metric("steps.up-down", "words of the world's memory read, leaps as distances up and down", "words")
  )

  val all: Seq[Metric] = Others ++ (for ((group, whose) <- Groups; (key, name, unit) <- Picture)
    yield Metric(s"$group.$key", s"$whose: $name", unit))

  private val byKey = all.map(m => m.key -> m).toMap

  /** A figure that has no name here is called by its key. */
  def of(key: String): Metric = byKey.getOrElse(key, Metric(key, key, ""))
}
