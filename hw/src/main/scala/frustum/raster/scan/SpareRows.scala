package frustum.raster.scan

import spinal.core._
import spinal.lib._

/** Access to the rows of the table that [[frustum.contract.raster.FetchProgram]] leaves free: `width` bits each,
  * readable while `free`, one cycle after `address`.
  */
case class SpareRows(rows: Int, width: Int) extends Bundle with IMasterSlave {
  val free = Bool()
  val address = UInt(log2Up(rows) bits)
  val data = UInt(width bits)
  val write = Flow(new Bundle { val address = UInt(log2Up(rows) bits); val data = UInt(width bits) })
  override def asMaster(): Unit = { out(address); in(free, data); master(write) }
}
