package frustum.driver.raster

/** The way to the hardware: simulated SPI, a serial adapter, a file. Carries whole wire commands, in order.
  */
trait Transport {

  /** Sends bytes (0..255); returns when they are on their way. */
  def send(bytes: Seq[Int]): Unit
}
