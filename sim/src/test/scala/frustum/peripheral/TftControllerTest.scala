package frustum.peripheral

import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.model.video.SpiDisplay
import org.scalatest.funsuite.AnyFunSuite

class TftControllerTest extends AnyFunSuite {
  private val config = RasterConfig(tileLog2Width = 5)

  private def started(panel: Panel): TftController = {
    val tft = new TftController(panel)
    tft.reset(timeMs = 1, lowMs = 1)
    SpiDisplay.start(config, panel).zipWithIndex.foreach { case ((data, value), i) =>
      tft.byte(data, value, 122 + (if (i > 0) 121 else 0))
    }
    tft
  }

  for (panel <- Panel.all) {
    test(s"${panel.name}: a proper start is no violation, windows wrap") {
      val tft = started(panel)
      val pixels = Seq.tabulate(32 * 16 + 1)(i => SpiDisplay.Pixel(i * 100 & 0xffff, i == 0, 2, 3))
      SpiDisplay.tiles(config, pixels).foreach { case (data, value) => tft.byte(data, value, 300) }
      val picture = tft.picture(240, 320)
      assert(picture(48 * 240 + 64) == (512 * 100 & 0xffff)) // the last one began again at the top left
      assert(picture(48 * 240 + 65) == 100 && picture(49 * 240 + 64) == 3200 && picture(63 * 240 + 95) == 51100)
      assert(tft.violations.isEmpty, tft.violations.mkString("; "))
    }

    test(s"${panel.name}: what a controller would not accept is noted") {
      def after(bytes: (Boolean, Int)*): Seq[String] = {
        val tft = started(panel)
        bytes.foreach { case (data, value) => tft.byte(data, value, 300) }
        tft.violations.toSeq
      }
      assert(after((false, 0x77)).head.contains("unknown command 0x77"))
      assert(after(
        (false, Panel.ColumnAddress),
        (true, 0),
        (false, Panel.MemoryWrite)
      ).head.contains("with 1 bytes, not 4"))
      assert(after((false, Panel.MemoryWrite), (true, 1), (false, Panel.MemoryWrite)).head.contains("half a pixel"))
      assert(after((false, Panel.RowAddress), (true, 0), (true, 9), (true, 0), (true, 5)).head.contains("rows 9 to 5"))
      assert(after((false, Panel.SleepOut), (false, Panel.DisplayOn)).head.contains("too soon"))
      val never = new TftController(panel)
      never.byte(data = false, Panel.DisplayOn, 500)
      assert(never.violations.head.contains("without a reset") && never.violations(1).contains("before sleep out"))
      val short = new TftController(panel)
      short.reset(1, lowMs = 0.001)
      assert(short.violations.head.contains("reset low for"))
    }
  }
}
