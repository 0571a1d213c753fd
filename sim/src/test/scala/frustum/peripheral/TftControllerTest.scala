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

  for (panel <- Panel.whole) {
    test(s"${panel.name}: a proper start is no violation, windows wrap") {
      val tft = started(panel)
      val pixels = Seq.tabulate(32 * 16 + 1)(i => SpiDisplay.Pixel(i * 100 & 0xffff, i == 0, 2, 3))
      SpiDisplay.tiles(config, panel, pixels).foreach { case (data, value) => tft.byte(data, value, 300) }
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

  /** Rows of a small screen sent to one panel as if it were another. */
  private def shown(glass: Panel, driven: Panel, width: Int, height: Int): (Boolean, Seq[String]) = {
    val c = RasterConfig(width = width, height = height, tileLog2Width = 4, tileLog2Height = 4)
    val tft = new TftController(glass)
    tft.reset(timeMs = 1, lowMs = 1)
    SpiDisplay.start(c, driven).zipWithIndex.foreach { case ((data, value), i) =>
      tft.byte(data, value, 122 + (if (i > 0) 121 else 0))
    }
    def color(x: Int, y: Int) = (x * 77 + y * 1031) & 0xffff
    for {
      ty <- 0 until c.tilesY; tx <- 0 until c.tilesX
      pixels = for (y <- 16 * ty until (16 * ty + 16).min(height); x <- 16 * tx until (16 * tx + 16).min(width))
        yield SpiDisplay.Pixel(color(x, y), x == 16 * tx && y == 16 * ty, tx, ty)
      (data, value) <- SpiDisplay.tiles(c, driven, pixels)
    } tft.byte(data, value, 300)
    val right = Array.tabulate(width * height)(i => color(i % width, i / width))
    (tft.picture(width, height).sameElements(right), tft.violations.toSeq)
  }

  for (
    panel <- Panel.all; turned <- 0 to 3;
    (long, short) = (panel.glass.width.max(panel.glass.height), panel.glass.width.min(panel.glass.height))
  ) {
    val module = if (turned == 0) panel else panel.turnedBy(turned)
    test(s"${module.name}: the whole glass upright and on its side, turned by $turned quarters") {
      for ((w, h) <- Seq((short, long), (long, short)).distinct)
        assert(shown(module, module, w, h) == ((true, Nil)), s"$w x $h")
    }
  }

  test("a window without the module's offset is seen") {
    for (module <- Panel.all.filterNot(Panel.whole.contains) if module != Panel.St7789Square) {
      val (w, h) = (module.glass.width, module.glass.height)
      val plain = Panel.St7789.copy(name = module.name, turned = module.turned)
      assert(!shown(module, plain, w, h)._1, module.name)
    }
  }

  test("sizes that a glass does not show are refused with both") {
    assert(Panel.St7789Small.fault(240, 240).exists(f => f.contains("240 x 240") && f.contains("135 x 240")))
    assert(Panel.St7789Small.fault(240, 135).isEmpty && Panel.Ili9341.fault(320, 240).isEmpty && Panel.Ili9341.fault(
      321,
      240
    ).isDefined)
  }
}
