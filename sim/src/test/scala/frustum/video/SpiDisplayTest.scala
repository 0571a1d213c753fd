package frustum.video

import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.harness.{FrustumSim, Simulated, ThreadTime}
import frustum.model.video.{SpiDisplay => DisplayModel}
import frustum.peripheral.{SimTft, SimTftReader, TftController}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.sim._
import spinal.lib._

import scala.collection.mutable.ArrayBuffer
import scala.util.Random

/** The display unit, the simulated panel's port, and a source of pixels that needs no JVM: pixel n is a hash of n.
  *
  * @param selectPin of the module at the pins
  */
case class DisplayTop(
    config: RasterConfig,
    panel: Panel,
    fast: Int,
    clocksPerBit: Int,
    free: Boolean,
    selectPin: Boolean
) extends Component {
  val io = new Bundle {
    val pixels = slave(Stream(ResolvedPixel(config)))
    val pins = out(DisplayPins())
    val frames = in UInt (8 bits) // that the built-in source sends
  }
  val display = SpiDisplay(config, panel, DisplayTop.ClockHz, clocksPerBit, fast)
  val tft = SimTft(gapLog2 = 8, selectPin = selectPin)
  io.pins := display.io.pins
  tft.io.pins := display.io.pins
  if (!free) display.io.pixels << io.pixels
  else {
    io.pixels.ready := False
    val x, y, frame = RegInit(U(0, 12 bits))
    val up = display.io.pixels
    val tileX = x >> config.tileLog2Width
    val tileY = y >> config.tileLog2Height
    val endX = x(config.tileLog2Width - 1 downto 0).andR || x === config.width - 1
    val endY = y(config.tileLog2Height - 1 downto 0).andR || y === config.height - 1
    up.valid := frame < io.frames.resize(12)
    up.color := (x * 77 + y * 1031).resize(16).asBits
    up.first := x(config.tileLog2Width - 1 downto 0) === 0 && y(config.tileLog2Height - 1 downto 0) === 0
    up.tileX := tileX.resized
    up.tileY := tileY.resized
    when(up.fire) {
      x := x + 1
      when(endX) {
        x := (tileX << config.tileLog2Width).resized
        y := y + 1
        when(endY) {
          y := (tileY << config.tileLog2Height).resized
          x := x + 1
          when(x === config.width - 1) {
            x := 0
            y := y + 1
            when(y === config.height - 1) { y := 0; frame := frame + 1 }
          }
        }
      }
    }
  }
}
object DisplayTop {
  val ClockHz = 36000000L

  def apply(config: RasterConfig, panel: Panel, fast: Int, clocksPerBit: Int, free: Boolean): DisplayTop =
    DisplayTop(config, panel, fast, clocksPerBit, free, panel.selectPin)
}

class SpiDisplayTest extends AnyFunSuite with Simulated {
  private val fast = 4000

  /** Pixels of a whole picture, tile by tile. */
  private def pixels(config: RasterConfig, picture: Array[Int]): Seq[DisplayModel.Pixel] =
    for {
      ty <- 0 until config.tilesY; tx <- 0 until config.tilesX
      y <- ty * config.tileHeight until ((ty + 1) * config.tileHeight).min(config.height)
      x <- tx * config.tileWidth until ((tx + 1) * config.tileWidth).min(config.width)
    } yield DisplayModel.Pixel(
      picture(y * config.width + x),
      x % config.tileWidth == 0 && y % config.tileHeight == 0,
      tx,
      ty
    )

  private def drive(dut: DisplayTop, pixels: Seq[DisplayModel.Pixel], stall: Double): Unit =
    for (p <- pixels) {
      while (simRandom.nextDouble() < stall) dut.clockDomain.waitSampling(7)
      dut.io.pixels.valid #= true
      dut.io.pixels.color #= p.color
      dut.io.pixels.first #= p.first
      dut.io.pixels.tileX #= p.tileX
      dut.io.pixels.tileY #= p.tileY
      dut.clockDomain.waitSamplingWhere(dut.io.pixels.ready.toBoolean)
      dut.io.pixels.valid #= false
    }

  for {
    (panel, config, clocksPerBit) <- Seq(
      (Panel.Ili9341, RasterConfig(width = 44, height = 40, tileLog2Width = 4, tileLog2Height = 3), 2),
      (Panel.St7789, RasterConfig(width = 44, height = 40), 2),
      (Panel.Ili9341, RasterConfig(width = 264, height = 8, tileLog2Height = 3), 2),
      (Panel.St7789, RasterConfig(width = 264, height = 8, tileLog2Height = 3), 4),
      (Panel.St7789Square, RasterConfig(width = 44, height = 40), 2),
      (Panel.St7789SquareTurned, RasterConfig(width = 44, height = 40), 4),
      (Panel.St7789Round, RasterConfig(width = 44, height = 40), 2),
      (Panel.St7789Round, RasterConfig(width = 264, height = 8, tileLog2Height = 3), 2),
      (Panel.St7789Small, RasterConfig(width = 44, height = 40), 2),
      (Panel.St7789Small, RasterConfig(width = 136, height = 8, tileLog2Height = 3), 2)
    )
  } test(
    s"${panel.name}, ${config.width} x ${config.height}, $clocksPerBit clocks a bit: bytes as modelled, picture right"
  ) {
    val sim = FrustumSim.compile(s"Display_${panel.name}_${config.width}")(DisplayTop(
      config,
      panel,
      fast,
      clocksPerBit,
      free = false
    ))
    for ((stall, seed) <- Seq((0.0, 1), (0.6, 2))) sim.doSim(s"stall$stall", seed) { dut =>
      val random = new Random(seed)
      val picture = Array.fill(config.width * config.height)(random.nextInt(65536))
      val stream = pixels(config, picture)
      val tft = new TftController(panel)
      val reader = new SimTftReader(dut.tft, tft, DisplayTop.ClockHz, fast)
      val bytes = DisplayModel.start(config, panel) ++ DisplayModel.tiles(config, panel, stream)
      dut.io.pixels.valid #= false
      dut.io.frames #= 0
      SimTimeout(10L * 4000000)
      val got = collect(dut, panel.selectPin)
      dut.clockDomain.forkStimulus(period = 10)
      dut.clockDomain.waitSampling(20) // before the end of reset `ready` is anything
      drive(dut, stream, stall)
      dut.clockDomain.waitSampling(40 * clocksPerBit)
      reader.drain()
      assert(got.map(g => (g._1, g._2)) == bytes, s"seed $seed, stall $stall")
      assert(tft.violations.isEmpty, s"seed $seed, stall $stall: ${tft.violations.mkString("; ")}")
      assert(tft.picture(config.width, config.height).sameElements(picture), s"seed $seed, stall $stall")
      if (stall == 0) {
        val tile = bytes.length - 2 * config.tileWidth // within the last tiles: one byte after the other
        val times = got.map(_._3).slice(tile, bytes.length)
        assert(times.zip(times.tail).forall { case (a, b) => b - a == 8 * clocksPerBit }, "gaps between bytes")
      }
    }
  }

  /** (D/C, byte, clock) at the pins, by the JVM: independent of the simulated hardware. */
  private def collect(dut: DisplayTop, selectPin: Boolean): ArrayBuffer[(Boolean, Int, Long)] = {
    val got = ArrayBuffer.empty[(Boolean, Int, Long)]
    var (sck, shift, count, clock) = (false, 0, 0, 0L)
    dut.clockDomain.onSamplings {
      clock += 1
      val now = dut.io.pins.sck.toBoolean
      if (selectPin && dut.io.pins.cs.toBoolean || !dut.io.pins.reset.toBoolean) count = 0
      else if (now && !sck) {
        shift = (shift << 1 | (if (dut.io.pins.mosi.toBoolean) 1 else 0)) & 255
        count += 1
        if (count == 8) { got += ((dut.io.pins.dc.toBoolean, shift, clock)); count = 0 }
      }
      sck = now
    }
    got
  }

  for ((panel, wrong) <- Seq(Panel.St7789Square -> false, Panel.St7789Square.copy(selectPin = true) -> true))
    test(s"a module without chip select in SPI mode ${if (wrong) 0 else 3}: ${if (wrong) "noted" else "accepted"}") {
      val config = RasterConfig(width = 16, height = 16, tileLog2Width = 4)
      val name = s"Display_select_$wrong"
      FrustumSim.compile(name)(DisplayTop(config, panel, fast, 2, free = true, selectPin = false)).doSim("rest", 1) {
        dut =>
          dut.io.pixels.valid #= false
          dut.io.frames #= 1
          dut.clockDomain.forkStimulus(period = 10)
          val tft = new TftController(panel)
          val reader = new SimTftReader(dut.tft, tft, DisplayTop.ClockHz, fast)
          dut.clockDomain.waitSampling(20000)
          reader.drain()
          assert(tft.pixels == 256)
          assert(
            tft.violations.exists(_.contains("SPI mode 3")) == wrong && (wrong || tft.violations.isEmpty),
            tft.violations
          )
      }
    }

  test("SPI mode 3 with a clock a bit is refused") {
    val e = intercept[IllegalArgumentException](FrustumSim.spinalConfig.generateVerilog(
      SpiDisplay(RasterConfig(width = 16, height = 16), Panel.St7789Square, DisplayTop.ClockHz, clocksPerBit = 1)
    ))
    assert(e.getMessage.contains("mode 3"))
  }

  test("two whole frames of 240 x 320 at the pins, in under 10 s each") {
    val config = RasterConfig()
    val sim = FrustumSim.compile("Display_frame")(DisplayTop(config, Panel.Ili9341, fast, 2, free = true))
    var readTime = 0.0
    val (time, _) = ThreadTime.of {
      sim.doSim("frames", 1) { dut =>
        dut.io.pixels.valid #= false
        dut.io.frames #= 2
        dut.clockDomain.forkStimulus(period = 10)
        val tft = new TftController(Panel.Ili9341)
        val reader = new SimTftReader(dut.tft, tft, DisplayTop.ClockHz, fast)
        readTime = ThreadTime.of {
          while (tft.pixels < 2 * config.width * config.height) { sleep(10L * 200000); reader.drain() }
        }._1
        assert(tft.violations.isEmpty, tft.violations.mkString("; "))
        val expected = Array.tabulate(config.width * config.height)(i => (i % 240 * 77 + i / 240 * 1031) & 0xffff)
        assert(tft.picture(config.width, config.height).sameElements(expected))
      }
    }
    val seconds = time + readTime // the body of a simulation has a thread of its own
    info(f"$seconds%.1f s for two frames")
    assert(seconds < 20)
  }
}
