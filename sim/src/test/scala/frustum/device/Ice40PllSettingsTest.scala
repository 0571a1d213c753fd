package frustum.device

import org.scalatest.funsuite.AnyFunSuite

class Ice40PllSettingsTest extends AnyFunSuite {
  test("known dividers of the 12 MHz oscillator") {
    val known = Seq(
      ("36", 0, 47, 4),
      ("36.75", 0, 48, 4),
      ("39.75", 0, 52, 4),
      ("40.5", 0, 53, 4),
      ("48", 0, 63, 4),
      ("25.5", 0, 67, 5)
    )
    for ((mhz, divr, divf, divq) <- known) {
      val settings = Ice40PllSettings(BigDecimal(12), BigDecimal(mhz))
      assert((settings.divr, settings.divf, settings.divq) == ((divr, divf, divq)), s"at $mhz MHz")
      assert(settings.outputMHz == BigDecimal(mhz))
      assert(settings.filterRange == 1)
    }
  }

  test("a frequency between two settings is refused with its neighbours") {
    val error = intercept[IllegalArgumentException](Ice40PllSettings(BigDecimal(12), BigDecimal("36.1")))
    assert(error.getMessage.contains("36 or 36.75 MHz"))
  }

  test("frequencies beyond the part are refused with their numbers") {
    assert(intercept[IllegalArgumentException](Ice40PllSettings(
      BigDecimal(12),
      BigDecimal(300)
    )).getMessage.contains("300"))
    assert(intercept[IllegalArgumentException](Ice40PllSettings(
      BigDecimal(5),
      BigDecimal(36)
    )).getMessage.contains("10..133"))
    assert(intercept[IllegalArgumentException](Ice40PllSettings(12, 0, 10, 4)).getMessage.contains("oscillator"))
  }

  test("the loop filter follows the phase detector") {
    for ((mhz, range) <- Seq((12, 1), (16, 1), (20, 2), (30, 3), (50, 4), (100, 5), (125, 6))) {
      assert(Ice40PllSettings.all(BigDecimal(mhz)).filter(_.divr == 0).forall(_.filterRange == range), s"at $mhz MHz")
    }
  }
}
