package frustum.fit

import frustum.contract.InputError
import frustum.contract.raster.{Combine, PlaneFormats}
import frustum.driver.raster.{Driver, PreparedFrame, StateTable, TextureMemory}
import frustum.driver.scene.Scene
import frustum.engine.raster.RasterEngines
import frustum.judge.{EndToEndJudge, Flip, FrameJudge, LoggedFragment}
import frustum.referee.WorldView
import frustum.reference.raster.ReferenceRaster
import scala.math.pow
import scala.util.Random

/** A view as the model draws it: its picture as 0xRRGGBB, and the fragments of each pass. */
final case class DrawnView(frame: PreparedFrame, picture: Array[Int], logs: Seq[IndexedSeq[LoggedFragment]])

/** Searches the formats with which every view of a volume stays within a budget.
  *
  * Precision is searched at half the budget on views drawn by lot; then the camera climbs to worse views, which are
  * added, until it finds none over the half. The verdict is on other views, at the whole budget.
  *
  * @param say told of each step
  */
final class Fit(
    scene: Scene,
    features: FitFeatures,
    budget: FitBudget,
    volume: CameraVolume,
    seed: Long,
    say: String => Unit
) {
  private val judge = new FrameJudge(RasterEngines.model, simulated = false)
  private val states =
    StateTable(scene, TextureMemory.allocate(scene, features.config), features.options).states

  private val solid = Convexity.of(scene).contains(Convexity.Solid)

  /** What there is to be saved. */
  private val knobs: Seq[Knob] = Seq(
    Option.when(states.exists(_.combine != Combine.ColorOnly))(Knob.coordinate),
    Option.when(states.exists(_.combine != Combine.ColorOnly))(Knob.inverse),
    Option.when(features.options.depthTest && budget.primitivesWrong.isDefined)(Knob.depth),
    Option.when(states.exists(_.combine != Combine.Replace) && budget.flip.isDefined)(Knob.color)
  ).flatten

  def prepare(view: View, formats: PlaneFormats): PreparedFrame = Driver.prepare(
    scene,
    view.camera(scene.camera),
    features.options,
    features.config.copy(formats = formats),
    0
  )

  def drawn(view: View, formats: PlaneFormats): DrawnView = {
    val frame = prepare(view, formats)
    val (_, picture, logs) = judge.drawModel(frame)
    DrawnView(frame, picture, logs)
  }

  /** What the driver is asked for. */
  def asked(view: View): WorldView =
    EndToEndJudge.view(scene, view.camera(scene.camera), features.options, features.config)

  def errors(view: View, formats: PlaneFormats): ViewErrors = {
    if (solid && Convexity.inside(scene, view.camera(scene.camera).eye))
      throw InputError(
        s"${scene.name}: the view with $view is from inside the mesh; give a --volume with greater distances"
      )
    val frame = prepare(view, formats)
    val (verdict, image, logs) = judge.drawModel(frame)
    val screen = frame.config.width * frame.config.height
    // Without a depth test no pixel may be drawn twice: it counts as a wrong texel.
    val twice =
      if (features.options.depthTest) 0
      else logs.map(log => log.length - log.iterator.map(f => f.y << 16 | f.x).toSet.size).sum
    ViewErrors(
      100.0 * (verdict.texels.wrong + twice) / verdict.texels.judged.max(1),
      100.0 * verdict.depth.primitiveWrong / screen,
      budget.flip.map(_ =>
        new Flip(frame.config.width, frame.config.height).mean(ReferenceRaster.draw(frame).rgb888, image)
      )
    )
  }

  private def share(view: View, formats: PlaneFormats): Double = budget.share(errors(view, formats))

  private def holds(views: Seq[View], formats: PlaneFormats): Boolean =
    views.forall(share(_, formats) <= Fit.Margin)

  /** Formats with the most bits dropped that hold; knob by knob, from the one that saves most, and then bit by bit as
    * long as there is a knob that has one more: errors of one may make good for another's.
    */
  private def search(views: Seq[View]): PlaneFormats = furthered(
    views,
    knobs.foldLeft(PlaneFormats()) { (formats, knob) =>
      def bisect(good: Int, bad: Int): Int =
        if (bad - good <= 1) good
        else {
          val middle = (good + bad) / 2
          if (holds(views, knob.set(formats, middle))) bisect(middle, bad) else bisect(good, middle)
        }
      knob.set(formats, bisect(0, knob.most(formats) + 1))
    }
  )

  @annotation.tailrec
  private def furthered(views: Seq[View], formats: PlaneFormats): PlaneFormats =
    oneLess(formats).find { case (_, less) => holds(views, less) } match {
      case Some((_, less)) => furthered(views, less)
      case None            => formats
    }

  /** By each knob that can, a bit less. */
  private def oneLess(formats: PlaneFormats): Seq[(Knob, PlaneFormats)] = knobs
    .filter(k => k.get(formats) < k.most(formats))
    .map(k => k -> k.set(formats, k.get(formats) + 1))

  /** A worse view than this, if a climb finds one. */
  private def climb(from: View, formats: PlaneFormats, r: Random): (View, Double) =
    (0 until Fit.ClimbSteps).foldLeft((from, share(from, formats))) { case ((best, worst), step) =>
      val next = volume.near(best, 0.3 * pow(0.8, step), r)
      val found = share(next, formats)
      if (found > worst) (next, found) else (best, worst)
    }

  def run(): FitResult = {
    val random = new Random(seed)
    @annotation.tailrec
    def refine(views: Seq[View], round: Int): (Seq[View], PlaneFormats) = {
      val formats = search(views)
      val ranked = views.sortBy(-share(_, formats))
      val climbed = ranked.take(Fit.Climbers).map(climb(_, formats, random))
      val over = climbed.filter(_._2 > Fit.Margin).map(_._1)
      say(
        s"round $round: $formats for ${views.length} views, worst at ${percent(climbed.map(_._2).max)} of the budget" +
          (if (over.isEmpty) "" else s", ${over.length} worse views added")
      )
      if (over.isEmpty || round == Fit.Rounds || formats == PlaneFormats()) (over ++ ranked, formats)
      else refine(over ++ ranked, round + 1)
    }
    val (views, formats) = refine(Seq.fill(Fit.TrainingViews)(volume.random(random)), 1)
    val unused = new Random(seed + Fit.HeldOutSeed)
    val heldOut = Seq.fill(Fit.HeldOutViews)(volume.random(unused)).map(v => v -> errors(v, formats))
    FitResult(
      features.copy(config = features.config.copy(formats = formats)),
      budget,
      trained = views.map(v => v -> errors(v, formats)),
      heldOut,
      oneBitLess = oneLess(formats).map { case (k, less) => k.name -> views.map(share(_, less)).max }
    )
  }
  private def percent(share: Double) = f"${100 * share}%.0f %%"
}

/** A number of bits that can be saved. */
private final case class Knob(
    name: String,
    most: PlaneFormats => Int,
    get: PlaneFormats => Int,
    set: (PlaneFormats, Int) => PlaneFormats
)
private object Knob {
  val coordinate: Knob = Knob(
    "coordinate",
    f => PlaneFormats.MostCoordinate.min(PlaneFormats.MostInverse - f.inverse),
    _.coordinate,
    (f, n) => f.copy(coordinate = n)
  )
  val inverse: Knob =
    Knob("inverse", PlaneFormats.MostInverse - _.coordinate, _.inverse, (f, n) => f.copy(inverse = n))
  val depth: Knob = Knob("depth", _ => PlaneFormats.MostDepth, _.depth, (f, n) => f.copy(depth = n))
  val color: Knob = Knob("color", _ => PlaneFormats.MostColor, _.color, (f, n) => f.copy(color = n))
}

object Fit {
  val TrainingViews = 16
  val HeldOutViews = 40
  val HeldOutSeed = 1000003L
  val Climbers = 2
  val ClimbSteps = 10
  val Rounds = 5

  /** Share of the budget that the search may use up. */
  val Margin = 0.5
}
