package frustum.lab

import frustum.InputError
import frustum.engine.Engines
import frustum.host.{DrawOptions, Driver, PreparedFrame, StateTable, TextureMemory}
import frustum.judge.{Flip, FrameJudge}
import frustum.reference.raster.ReferenceRaster
import frustum.scene.Scene
import frustum.spec.{Combine, FixedState, PlaneFormats, RasterConfig}
import scala.math.pow
import scala.util.Random

/** What may be wrong at most, in each view. None: not asked for.
  *
  * @param texelsWrong     per cent of judged texels
  * @param primitivesWrong per cent of the screen's pixels, that show another triangle than they should
  * @param flip            mean FLIP between the picture and the reference's
  */
final case class FitBudget(texelsWrong: Double, primitivesWrong: Option[Double], flip: Option[Double]) {

  /** Greatest error as a share of its budget: 1 is just met. */
  def share(e: ViewErrors): Double = Seq(
    Some(FitBudget.share(e.texelsWrong, texelsWrong)),
    primitivesWrong.map(FitBudget.share(e.primitivesWrong, _)),
    for (bound <- flip; f <- e.flip) yield FitBudget.share(f, bound)
  ).flatten.max
}
object FitBudget {
  private def share(error: Double, bound: Double) = if (error == 0) 0.0 else error / bound
}

/** Errors of one view, in the units of [[FitBudget]]. */
final case class ViewErrors(texelsWrong: Double, primitivesWrong: Double, flip: Option[Double])

/** What a scene needs by inspection: no view is drawn for it.
  *
  * @param config  nothing in it but what the scene's states can choose, and texel memory of the size it fills
  * @param options back faces are culled, and there is no depth test, where nothing can hide anything else
  */
final case class FitFeatures(config: RasterConfig, options: DrawOptions)

object FitFeatures {
  def apply(scene: Scene, base: RasterConfig, options: DrawOptions): FitFeatures = {
    val lone    = Convexity.of(scene)
    val drawn   = options.copy(cullBack = options.cullBack || lone.contains(Convexity.Solid), depthTest = lone.isEmpty)
    val memory  = TextureMemory.allocate(scene, base)
    val states  = StateTable(scene, memory, drawn).states
    val texels  = memory.uploads.map(u => u.base * TextureMemory.Unit + u.texels.length).maxOption.getOrElse(0)
    val rounded = Iterator.iterate(64)(_ * 2).find(_ >= texels).get
    FitFeatures(base.copy(textureTexels = rounded, fixed = FixedState.of(states: _*)), drawn)
  }
}

/** Searches the formats with which every view of a volume stays within a budget.
  *
  * Precision is searched at half the budget on views drawn by lot; then the camera climbs to worse views, which are added, until it
  * finds none over the half. The verdict is on other views, at the whole budget.
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
  private val judge  = new FrameJudge(Engines.model, simulated = false)
  private val states = StateTable(scene, TextureMemory.allocate(scene, features.config), features.options).states

  /** What there is to be saved. */
  private val knobs: Seq[Knob] = Seq(
    Option.when(states.exists(_.combine != Combine.ColorOnly))(Knob.coordinate),
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

  def errors(view: View, formats: PlaneFormats): ViewErrors = {
    val frame                  = prepare(view, formats)
    val (verdict, image, logs) = judge.drawModel(frame)
    val screen                 = frame.config.width * frame.config.height
    // Without a depth test no pixel may be drawn twice: it counts as a wrong texel.
    val twice =
      if (features.options.depthTest) 0 else logs.map(log => log.length - log.iterator.map(f => f.y << 16 | f.x).toSet.size).sum
    ViewErrors(
      100.0 * (verdict.texels.wrong + twice) / verdict.texels.judged.max(1),
      100.0 * verdict.depth.primitiveWrong / screen,
      budget.flip.map(_ => new Flip(frame.config.width, frame.config.height).mean(ReferenceRaster.draw(frame).rgb888, image))
    )
  }

  private def share(view: View, formats: PlaneFormats): Double = budget.share(errors(view, formats))

  private def holds(views: Seq[View], formats: PlaneFormats, part: Double): Boolean = views.forall(share(_, formats) <= part)

  /** Formats with the most bits dropped that hold; knob by knob, from the one that saves most. */
  private def search(views: Seq[View]): PlaneFormats =
    knobs.foldLeft(PlaneFormats()) { (formats, knob) =>
      def bisect(good: Int, bad: Int): Int =
        if (bad - good <= 1) good
        else {
          val middle = (good + bad) / 2
          if (holds(views, knob.set(formats, middle), Fit.Margin)) bisect(middle, bad) else bisect(good, middle)
        }
      knob.set(formats, bisect(0, knob.most + 1))
    }

  /** A worse view than this, if a climb finds one. */
  private def climb(from: View, formats: PlaneFormats, r: Random): (View, Double) =
    (0 until Fit.ClimbSteps).foldLeft((from, share(from, formats))) { case ((best, worst), step) =>
      val next  = volume.near(best, 0.3 * pow(0.8, step), r)
      val found = share(next, formats)
      if (found > worst) (next, found) else (best, worst)
    }

  def run(): FitResult = {
    val random = new Random(seed)
    @annotation.tailrec
    def refine(views: Seq[View], round: Int): (Seq[View], PlaneFormats) = {
      val formats = search(views)
      val ranked  = views.sortBy(-share(_, formats))
      val climbed = ranked.take(Fit.Climbers).map(climb(_, formats, random))
      val over    = climbed.filter(_._2 > Fit.Margin).map(_._1)
      say(
        s"round $round: $formats for ${views.length} views, worst at ${percent(climbed.map(_._2).max)} of the budget" +
          (if (over.isEmpty) "" else s", ${over.length} worse views added")
      )
      if (over.isEmpty || round == Fit.Rounds || formats == PlaneFormats()) (over ++ ranked, formats)
      else refine(over ++ ranked, round + 1)
    }
    val (views, formats) = refine(Seq.fill(Fit.TrainingViews)(volume.random(random)), 1)
    val unused  = new Random(seed + Fit.HeldOutSeed)
    val heldOut = Seq.fill(Fit.HeldOutViews)(volume.random(unused)).map(v => v -> errors(v, formats))
    FitResult(
      features.copy(config = features.config.copy(formats = formats)),
      budget,
      trained = views.map(v => v -> errors(v, formats)),
      heldOut,
      oneBitLess = knobs.filter(k => k.get(formats) < k.most).map { k =>
        val less = k.set(formats, k.get(formats) + 1)
        k.name -> views.map(share(_, less)).max
      }
    )
  }
  private def percent(share: Double) = f"${100 * share}%.0f %%"
}

/** A number of bits that can be saved. */
private final case class Knob(name: String, most: Int, get: PlaneFormats => Int, set: (PlaneFormats, Int) => PlaneFormats)
private object Knob {
  val coordinate: Knob = Knob("coordinate", PlaneFormats.MostCoordinate, _.coordinate, (f, n) => f.copy(coordinate = n))
  val depth: Knob      = Knob("depth", PlaneFormats.MostDepth, _.depth, (f, n) => f.copy(depth = n))
  val color: Knob      = Knob("color", PlaneFormats.MostColor, _.color, (f, n) => f.copy(color = n))
}

object Fit {
  val TrainingViews = 16
  val HeldOutViews  = 40
  val HeldOutSeed   = 1000003L
  val Climbers      = 2
  val ClimbSteps    = 10
  val Rounds        = 5

  /** Share of the budget that the search may use up. */
  val Margin = 0.5
}

/** The answer.
  *
  * @param trained,heldOut    views with their errors
  * @param oneBitLess for each number of bits, the worst share of the budget with one bit less: above [[Fit.Margin]]
  */
final case class FitResult(
    features: FitFeatures,
    budget: FitBudget,
    trained: Seq[(View, ViewErrors)],
    heldOut: Seq[(View, ViewErrors)],
    oneBitLess: Seq[(String, Double)]
) {
  val heldOutOver: Int = heldOut.count { case (_, e) => budget.share(e) > 1 }

  /** At most one of the views that took no part in the search is over. */
  def met: Boolean = heldOutOver <= 1

  /** Worst first. */
  def worst: Seq[(View, ViewErrors)] = (heldOut ++ trained).sortBy { case (_, e) => -budget.share(e) }

  /** What share of all views may be over, with a confidence of 95 %, when so many of so many were (Clopper and Pearson, 1934). */
  def overAtMost: Double = {
    val n                   = heldOut.length
    def likely(p: Double)   = (0 to heldOutOver).map { k =>
      (0 until k).map(i => (n - i).toDouble / (i + 1)).product * pow(p, k) * pow(1 - p, n - k)
    }.sum
    @annotation.tailrec
    def bisect(low: Double, high: Double): Double = {
      val p = (low + high) / 2
      if (high - low < 1e-6) p else if (likely(p) > 0.05) bisect(p, high) else bisect(low, p)
    }
    if (heldOutOver >= n) 1 else bisect(0, 1)
  }
}
