package frustum.device

import spinal.core._

/** Single-ported memory, one access per cycle, read data one cycle after `enable && !write`, held until the next read.
  * On the iCE40UP5K it is built of SPRAM blocks of 16 K x 16, elsewhere inferred.
  *
  * @param width a multiple of 16
  * @param maskBits of a word that a bit of the mask stands for: 16, 8 or 4
  */
case class SinglePortRam(words: Int, width: Int, tech: Tech = Tech.Generic, maskBits: Int = 16) extends Component {
  require(width % 16 == 0, s"SinglePortRam: width $width is not a multiple of 16")
  require(Seq(4, 8, 16).contains(maskBits), s"SinglePortRam: mask of $maskBits bits is not of 4, 8 or 16")
  val addressBits = log2Up(words)
  val io = new Bundle {
    val enable = in Bool ()
    val write = in Bool ()
    val address = in UInt (addressBits bits)
    val writeData = in Bits (width bits)
    val mask = in Bits (width / maskBits bits)
    val readData = out Bits (width bits)
  }

  /** The inferred memory, without vendor cells. */
  val inferred = (tech != Tech.Ice40) generate Mem(Bits(width bits), words)

  tech match {
    case Tech.Ice40 =>
      val blocks = (words + SpramBlock.Words - 1) / SpramBlock.Words
      val select = if (blocks > 1) io.address(addressBits - 1 downto 14) else U(0, 1 bits)
      val selected = RegNextWhen(select, io.enable && !io.write)
      val lanes = for (lane <- 0 until width / 16) yield {
        val outputs = for (block <- 0 until blocks) yield {
          val ram = SpramBlock()
          ram.io.CLOCK := ClockDomain.current.readClockWire
          ram.io.ADDRESS := io.address.resize(14).asBits
          ram.io.DATAIN := io.writeData(lane * 16, 16 bits)
          val mask = io.mask(lane * 16 / maskBits, 16 / maskBits bits)
          ram.io.MASKWREN := (if (maskBits == 16) B(0xf, 4 bits) else Cat((0 until 4).map(n => mask(n * 4 / maskBits))))
          ram.io.WREN := io.write && (if (maskBits == 16) mask.lsb else True) && select === block
          ram.io.CHIPSELECT := io.enable // all blocks read: the address need not reach this pin
          ram.io.STANDBY := False
          ram.io.SLEEP := False
          ram.io.POWEROFF := True
          ram.io.DATAOUT
        }
        if (blocks == 1) outputs.head else Vec(outputs)(selected.resized)
      }
      io.readData := Cat(lanes)
    case _: Tech.Inferred =>
      io.readData := inferred.readWriteSync(
        io.address,
        io.writeData,
        io.enable,
        io.write,
        mask = io.mask,
        readUnderWrite = dontCare
      )
  }
}

/** SB_SPRAM256KA of the iCE40 UltraPlus (Lattice TN1314): POWEROFF is active low, MASKWREN is per nibble. */
case class SpramBlock() extends BlackBox {
  setDefinitionName("SB_SPRAM256KA")
  val io = new Bundle {
    val CLOCK = in Bool ()
    val ADDRESS = in Bits (14 bits)
    val DATAIN = in Bits (16 bits)
    val MASKWREN = in Bits (4 bits)
    val WREN = in Bool ()
    val CHIPSELECT = in Bool ()
    val STANDBY = in Bool ()
    val SLEEP = in Bool ()
    val POWEROFF = in Bool ()
    val DATAOUT = out Bits (16 bits)
  }
  noIoPrefix()
}
object SpramBlock { val Words = 16384 }
