package frustum.engine.raster

import frustum.boards.icebreaker.RasterTop
import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.device.Tech
import frustum.peripheral.{SimSpiHost, SimTft}
import spinal.core._
import spinal.core.sim._

/** The board's top with what is connected to its pins: a host that honours `cts`, and a display.
  *
  * While `tftMux` is high the host talks to the display instead of the core: its chip select is the display's, and `dc`
  * is what the test says.
  */
case class PinsTestbed(config: RasterConfig, panel: Panel) extends Component {
  val io = new Bundle {
    val run = in Bool () // resetn
    val queued = in UInt (PinsTestbed.RingLog2 + 1 bits) // see SimSpiHost
    val frameStart = in UInt (PinsTestbed.RingLog2 + 1 bits) // value of `sent` before the frame's first byte
    val tftMux, dc = in Bool ()
    val firstBit = out(UInt(36 bits)) // clock at which the byte after `frameStart` began
    val lastBit = out(UInt(36 bits)) // clock of the display's last bit so far
    val sent = out(UInt(PinsTestbed.RingLog2 + 1 bits)) // bytes that have left the host
    val cts = out Bool ()
  }
  val top = RasterTop(config, panel, PinsTestbed.CoreMHz, Tech.Generic, PinsTestbed.Fast)
  val host = SimSpiHost(PinsTestbed.RingLog2)
  val tft = SimTft(gapLog2 = 8, selectPin = panel.selectPin)
  val time = RegInit(U(0, 36 bits))
  time := time + 1

  // Both sides run from one clock, which the top's clock tree hides from the check.
  top.io.flatten.foreach(_.addTag(crossClockDomain))
  top.io.clk := ClockDomain.current.readClockWire
  top.io.resetn := io.run
  top.io.host.sck := host.io.pins.sck
  top.io.host.mosi := host.io.pins.mosi
  top.io.host.cs := host.io.pins.cs || io.tftMux
  host.io.pins.miso := top.io.host.miso
  host.io.cts := top.io.cts
  host.io.bytes := io.queued
  top.io.tftMux := io.tftMux
  top.io.tftCs := host.io.pins.cs
  top.io.tftDc := io.dc
  tft.io.pins := top.io.display

  val before = RegNext(host.io.sent) init 0
  io.firstBit := RegNextWhen(time, before === io.frameStart && host.io.sent =/= io.frameStart)
  io.lastBit := RegNextWhen(time, top.io.display.sck && !RegNext(top.io.display.sck))
  io.sent := host.io.sent
  io.cts := top.io.cts
}

object PinsTestbed {
  val RingLog2 = 18
  val CoreMHz = BigDecimal(36)

  /** By how much the display's pauses at its start are shortened. */
  val Fast = 4000
}
