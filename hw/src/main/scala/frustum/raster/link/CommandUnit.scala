package frustum.raster.link

import frustum.contract.raster.StoreLayout
import spinal.core._
import spinal.lib._

/** Groups of a command from [[CommandReader]] to the unit that executes it, which receives no others. */
case class GroupPort() extends Bundle with IMasterSlave {
  val group = Stream(CommandGroup())
  val refuse = Bool() // refuses the command of the group that is taken
  override def asMaster(): Unit = { master(group); in(refuse) }
}

/** A word for the bank of the scene store that is being filled. */
case class StoreWrite(layout: StoreLayout) extends Bundle {
  val address = UInt(layout.bankAddressBits bits)
  val data = Bits(32 bits)
}
