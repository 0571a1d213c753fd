package frustum.demos.voxel

import spinal.core._
import spinal.lib._

/** Cuts a host's bytes into commands, see [[frustum.contract.voxel.VoxelHostCommand]]: an opcode, its payload, and a
  * byte that makes the sum of all 0 modulo 256. An unknown opcode, a wrong sum and a command that is cut short are
  * counted; so are commands that the unit behind it refuses.
  *
  * @param bytesOf payload of each opcode, in bytes
  * @param silence cycles after which the next byte begins a command
  */
case class HostFraming(bytesOf: Map[Int, Int], silence: Int) extends Component {
  val io = new Bundle {
    val bytes = slave(Flow(Bits(8 bits)))
    val opcode = out UInt (8 bits) // of the command whose payload comes; from the cycle after it
    val begins = out Bool () // pulses with the opcode of a new command
    val payload = master(Flow(Bits(8 bits)))
    val whole = out Bool () // pulses with the last byte if the sum is right
    val refuse = in Bool () // refuses the payload, with `whole`
    val refused = out(RegInit(U(0, 8 bits))) // refused commands; saturates
  }
  private val byte = io.bytes.payload.asUInt
  private val opcode = Reg(UInt(8 bits))
  private val sum = Reg(UInt(8 bits))
  private val left = Reg(UInt(log2Up(bytesOf.values.max + 2) bits)) init 0 // remaining bytes, including the last
  private val quiet = Timeout(silence)
  private val idle = left === 0
  private val last = left === 1
  private val total = sum + byte

  io.opcode := opcode
  io.begins := io.bytes.valid && idle
  io.payload.valid := io.bytes.valid && !idle && !last
  io.payload.payload := io.bytes.payload
  io.whole := io.bytes.valid && last && total === 0

  private val unknown = io.begins && !bytesOf.keys.toSeq.sorted.map(byte === _).orR
  private val damaged = io.bytes.valid && last && total =/= 0
  private val cutShort = !io.bytes.valid && quiet && !idle
  when(io.bytes.valid) {
    quiet.clear()
    sum := Mux(idle, byte, total)
    left := left - 1
    when(idle) {
      opcode := byte
      left := 0
      switch(byte) {
        for ((o, n) <- bytesOf.toSeq.sorted) is(o)(left := n + 1)
      }
    }
  } elsewhen (cutShort)(left := 0)
  when((unknown || damaged || cutShort || io.refuse) && !io.refused.andR)(io.refused := io.refused + 1)
}
