package frustum.synthesis

import frustum.arithmetic.Multiplier16
import frustum.charts.LongDivision
import frustum.contract.video.ColorFormat
import frustum.device.Tech
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.Component
import java.nio.file.Files

class RegisteredUnitTest extends AnyFunSuite {
  private def verilog(unit: => Component): String = {
    val folder = Files.createTempDirectory("registered")
    UnitVerilog.write(folder, "timed")(new RegisteredUnit(unit))
    Files.readString(folder.resolve("timed.v"))
  }

  test(
    "two data pins and the clock, whether the unit has registers, black boxes with a clock of their own, or neither"
  ) {
    for (
      unit <- Seq[() => Component](
        () => frustum.video.OrderedDither(ColorFormat.Rgb444),
        () => new LongDivision(8),
        () => Multiplier16(Tech.Ice40, signedA = false, signedB = false, add = true)
      )
    ) {
      val text = verilog(unit())
      val top = text.substring(text.indexOf("module timed"))
      val pins = top.substring(0, top.indexOf(");")).linesIterator.drop(1).map(_.trim.split("[ ,]+").last).toSet
      assert(pins.filterNot(_ == "reset") == Set("io_in", "io_out", "clk"), text.take(2000))
    }
  }
}
