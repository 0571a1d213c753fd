package frustum.raster.store

import frustum.contract.raster.{RasterConfig, StoreLayout}
import frustum.device.Tech
import frustum.harness.{Claims, Formal, Prover}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core._
import spinal.core.formal._
import spinal.lib._

/** The store between readers that may think better of a request and a writer that may not. */
class StoreClaims(layout: StoreLayout, clients: Int) extends Component {
  val unit = FormalDut(Store(layout, clients, Tech.Generic))
  val all = unit.io.clients.toSeq
  assumeInitial(clockDomain.isResetActive)
  for (client <- all) { anyseq(client.cmd.valid); anyseq(client.cmd.payload) }
  all.last.cmd.formalAssumesSlave()
  for (reader <- all.init) assume(!reader.cmd.write)

  assert(CountOne(all.map(_.cmd.fire)) <= 1)
  val reads = all.map(c => RegNext(c.cmd.fire && !c.cmd.write) init False)
  for ((client, read) <- all.zip(reads)) assert(client.rsp.valid === read)

  // What the memory is asked for is what the client asked for.
  val ram = unit.ram.io
  for (client <- all) {
    val cmd = client.cmd
    when(cmd.fire) {
      assert(ram.enable.pull() && ram.address.pull() === cmd.address && ram.write.pull() === cmd.write)
    }
    when(client.rsp.valid) { assert(client.rsp.payload === ram.readData.pull()) }
  }
  val writer = all.last.cmd
  when(ram.write.pull()) {
    assert(writer.fire && writer.write && ram.writeData.pull() === writer.data && ram.mask.pull().andR)
  }
}

class StoreProof extends AnyFunSuite {
  private val layout = StoreLayout(RasterConfig(8, 8, 3, 3, maxVertices = 3, maxTriangles = 1))

  test("one request a clock; each read is answered a clock later, to who asked", Formal) {
    Prover.prove("Store", depth = 3)(new StoreClaims(layout, 3))
  }
}
