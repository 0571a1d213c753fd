package frustum.device

/** Divider settings of an iCE40 PLL in simple feedback:
  * {{{ out = in (divf + 1) / ((divr + 1) 2^divq) }}}
  * with the limits of Lattice's sysCLOCK guide for the iCE40 UltraPlus: phase detector in / (divr + 1) at 10..133 MHz,
  * oscillator out 2^divq at 533..1066 MHz, output 16..275 MHz.
  *
  * @param inputMHz reference clock
  */
final case class Ice40PllSettings(inputMHz: BigDecimal, divr: Int, divf: Int, divq: Int) {
  import Ice40PllSettings._
  require(divr >= 0 && divr <= 15, s"PLL divr $divr is outside 0..15")
  require(divf >= 0 && divf <= 127, s"PLL divf $divf is outside 0..127")
  require(divq >= 1 && divq <= 6, s"PLL divq $divq is outside 1..6")

  val detectorMHz: BigDecimal = inputMHz / (divr + 1)
  val oscillatorMHz: BigDecimal = detectorMHz * (divf + 1)
  val outputMHz: BigDecimal = oscillatorMHz / (1 << divq)
  require(within(detectorMHz, Detector), s"PLL phase detector at $detectorMHz MHz is outside $Detector MHz")
  require(within(oscillatorMHz, Oscillator), s"PLL oscillator at $oscillatorMHz MHz is outside $Oscillator MHz")
  require(within(outputMHz, Output), s"PLL output $outputMHz MHz is outside $Output MHz")

  /** Loop filter setting: one more at each of these detector frequencies. */
  def filterRange: Int = 1 + FilterSteps.count(detectorMHz >= _)
}

object Ice40PllSettings {
  private val Detector = (BigDecimal(10), BigDecimal(133))
  private val Oscillator = (BigDecimal(533), BigDecimal(1066))
  private val Output = (BigDecimal(16), BigDecimal(275))
  private val FilterSteps = Seq(17, 26, 44, 66, 101).map(BigDecimal(_))

  private def within(x: BigDecimal, range: (BigDecimal, BigDecimal)) = x >= range._1 && x <= range._2

  /** Every setting this reference allows, the highest detector frequency (least jitter) first. */
  def all(inputMHz: BigDecimal): Seq[Ice40PllSettings] =
    for {
      divr <- 0 to 15
      detector = inputMHz / (divr + 1)
      if within(detector, Detector)
      divf <- 0 to 127
      if within(detector * (divf + 1), Oscillator)
      divq <- 1 to 6
      if within(detector * (divf + 1) / (1 << divq), Output)
    } yield Ice40PllSettings(inputMHz, divr, divf, divq)

  /** The settings that give exactly `outputMHz`; otherwise an error that names the nearest frequencies. */
  def apply(inputMHz: BigDecimal, outputMHz: BigDecimal): Ice40PllSettings = {
    val candidates = all(inputMHz)
    require(candidates.nonEmpty, s"no iCE40 PLL setting accepts a reference of $inputMHz MHz (10..133)")
    candidates.find(_.outputMHz == outputMHz).getOrElse {
      val below = candidates.map(_.outputMHz).filter(_ < outputMHz).reduceOption(_ max _)
      val above = candidates.map(_.outputMHz).filter(_ > outputMHz).reduceOption(_ min _)
      val near = (below ++ above).mkString(" or ")
      throw new IllegalArgumentException(
        s"requirement failed: an iCE40 PLL cannot make $outputMHz MHz of $inputMHz MHz; the nearest is $near MHz"
      )
    }
  }
}
