package frustum.voxel

import frustum.blackbox.{SpramBlock, Tech}
import frustum.spec.VoxelConfig
import spinal.core._
import spinal.lib._

/** A word to be put into the world's memory; see [[frustum.spec.LeapField]]. */
case class WorldWrite(c: VoxelConfig) extends Bundle {
  val address = UInt(c.size.addressBits bits)
  val word    = Bits(c.leaps.wordBits bits)
}

/** The world's memory: a read a clock, the word a clock later; while a word is written the one read is not defined.
  *
  * On the iCE40UP5K it is built of SPRAM, two words of 8 bits in one of its own, and 65,536 of them in two blocks.
  */
case class WorldMemory(c: VoxelConfig, tech: Tech) extends Component {
  val io = new Bundle {
    val read  = slave(WorldReadBus(c))
    val write = slave(Flow(WorldWrite(c)))
  }

  /** Inferred memory alone: simulations reach into it. */
  val words = tech match {
    case _: Tech.Inferred =>
      val words = Mem(Bits(c.leaps.wordBits bits), c.size.blocks)
      io.read.word := words.readSync(io.read.address)
      words.write(io.write.address, io.write.word, io.write.valid)
      Some(words)
    case Tech.Ice40 =>
      require(
        c.leaps.wordBits <= 8,
        s"a word of ${c.leaps.wordBits} bits; in the iCE40's SPRAM it has at most 8"
      )
      val perBlock = 2 * SpramBlock.Words
      val blocks   = (c.size.blocks + perBlock - 1) / perBlock
      require(
        blocks <= 4,
        s"a world of ${c.size}, ${c.size.blocks} blocks; the iCE40UP5K's SPRAM holds ${4 * perBlock}"
      )
      val address  = Mux(io.write.valid, io.write.address, io.read.address)
      val upper    = RegNext(address(0))
      val select   = (address >> 15).resize(2)
      val selected = RegNext(select)
      val outputs  = for (block <- 0 until 4) yield {
        if (block >= blocks) B(0, 16 bits)
        else {
          val ram = SpramBlock()
          ram.io.CLOCK      := ClockDomain.current.readClockWire
          ram.io.ADDRESS    := (address >> 1).resize(14).asBits
          ram.io.DATAIN     := io.write.word.resize(8) ## io.write.word.resize(8)
          ram.io.MASKWREN   := Mux(address(0), B"1100", B"0011")
          ram.io.WREN       := io.write.valid && select === block
          ram.io.CHIPSELECT := True
          ram.io.STANDBY    := False
          ram.io.SLEEP      := False
          ram.io.POWEROFF   := True
          ram.io.DATAOUT
        }
      }
      val word = Vec(outputs)(selected)
      io.read.word := Mux(upper, word(15 downto 8), word(7 downto 0)).resized
      None
  }
}
