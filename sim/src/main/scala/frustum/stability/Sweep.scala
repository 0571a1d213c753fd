package frustum.stability

import frustum.contract.{InputError, ValidFor}
import scala.math.{pow, sqrt}

/** How a method fares at one value of what it depends on. */
sealed abstract class Stability(val name: String)
object Stability {

  /** Within the method's bound. */
  case object Safe extends Stability("safe")

  /** Beyond the bound, and still of use. */
  case object Degraded extends Stability("degraded")
  case object Broken extends Stability("broken")

  /** Nothing is drawn: generator, driver or the hardware's door say why. */
  case object Refused extends Stability("refused")
  val all: Seq[Stability] = Seq(Safe, Degraded, Broken, Refused)
}

/** What was found at a value: an error, or the reason why it was refused. */
final case class Trial(value: Double, state: Stability, error: Option[Double], reason: Option[String])

/** Between two values of different state. */
final case class Border(value: Double, below: Stability, above: Stability)

/** Where compared systems work, of the same quantity; no range where there is none. */
final case class PeerDomain(range: Option[(Double, Double)], what: String)
object PeerDomain {
  def apply(low: Double, high: Double, what: String): PeerDomain = PeerDomain(Some((low, high)), what)
}

/** What a sweep found, values ascending. */
final case class SweepResult(sweep: Sweep, trials: Seq[Trial], borders: Seq[Border]) {

  /** Stretches of one state, ends included. */
  def stretches: Seq[(Double, Double, Stability)] = {
    val cuts = sweep.from +: borders.map(_.value) :+ sweep.to
    cuts.zip(cuts.tail).zip(trials.head.state +: borders.map(_.above)).map { case ((a, b), s) => (a, b, s) }
  }

  /** What must not be: a broken promise, or garbage in silence. */
  def failures: Seq[String] = {
    val promises = trials.collect {
      case t if sweep.domain.contains(t.value) && t.state != Stability.Safe =>
        s"${sweep.name} ${t.value} is in the declared domain and ${t.state.name}: " +
          t.error.fold(t.reason.mkString)(e =>
            s"off by $e ${sweep.domain.errorUnit}, bound ${sweep.domain.bound}"
          )
    }
    promises ++ stretches.collect { case (from, to, Stability.Broken) =>
      s"${sweep.name} from $from to $to is drawn broken, and nothing refuses it"
    }
  }
}

/** Drives a method through what it depends on, within its domain and beyond.
  *
  * @param from,to where to; above 0 unless `whole`
  * @param whole   whole numbers, evenly spaced; otherwise evenly by their logarithm
  * @param broken  errors above this are of no use to anybody
  * @param error   error at a value, the same at every call; what is refused throws InputError, or fails a `require`
  */
final case class Sweep(
    domain: ValidFor,
    from: Double,
    to: Double,
    broken: Double,
    peer: Option[PeerDomain] = None,
    whole: Boolean = false
)(error: Double => Double) {
  val name: String = domain.quantity

  def at(value: Double): Trial =
    try {
      val e = error(value)
      val state =
        if (e <= domain.bound) Stability.Safe else if (e <= broken) Stability.Degraded else Stability.Broken
      Trial(value, state, Some(e), None)
    } catch {
      case InputError(reason)          => Trial(value, Stability.Refused, None, Some(reason))
      case e: IllegalArgumentException =>
        Trial(value, Stability.Refused, None, Some(e.getMessage.stripPrefix("requirement failed: ")))
    }

  /** Samples and the ends of the domain, and by bisection where one state becomes another. */
  def run(samples: Int = Sweep.Samples): SweepResult = {
    val spread = (0 to samples).map { i =>
      val f = i.toDouble / samples
      if (whole) scala.math.rint(from + f * (to - from)) else from * pow(to / from, f)
    }
    val ends = Seq(domain.low, domain.high).filter(v => v >= from && v <= to)
    val trials = (spread ++ ends).distinct.sorted.map(at)
    val borders = trials.zip(trials.tail).flatMap { case (a, b) => bisect(a, b) }
    SweepResult(this, trials, borders)
  }

  /** Borders between two trials; a third state that shows up between them has borders of its own. */
  private def bisect(low: Trial, high: Trial): Seq[Border] = {
    val middle = if (whole) scala.math.floor((low.value + high.value) / 2) else sqrt(low.value * high.value)
    val settled = if (whole) middle == low.value else high.value / low.value < Sweep.Precision
    if (low.state == high.state) Nil
    else if (settled) Seq(Border(if (whole) high.value else middle, low.state, high.state))
    else {
      val m = at(middle)
      bisect(low, m) ++ bisect(m, high)
    }
  }
}

object Sweep {
  val Samples = 16
  val Precision = 1.01

  val all: Seq[Sweep] =
    TriangleSweeps.all ++ SceneSweeps.all ++ UnitSweeps.all ++ RaySweeps.all ++ VoxelSweeps.all
}
