package frustum.raster.tile

import frustum.contract.raster.RasterConfig
import frustum.harness.{FrustumSim, Simulated}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

class TileMemoryTest extends AnyFunSuite with Simulated {
  private val config = RasterConfig(19, 21, 3, 3)
  private val words = 64
  private val seed = 9

  for (resolved <- Seq(true, false))
    test(s"a bank is drawn to while the other is ${if (resolved) "resolved and cleared" else "cleared"}") {
      FrustumSim.compile(s"TileMemory_$resolved")(TileMemory(config, 16, resolved)).doSim(seed) { dut =>
        val r = new Random(seed)
        val banks = Array.fill(2, words)(0)
        var drawn = 0 // what was read last, and must still be shown
        var shown = 0
        var reads, resolves = 0
        val clear = dut.io.clear
        dut.io.readEnable #= false
        dut.io.writeEnable #= 0
        Seq(clear.active, clear.all, clear.read, clear.write, clear.done).foreach(_ #= false)
        dut.clockDomain.forkStimulus(10)
        dut.clockDomain.waitSampling()

        clear.all #= true
        clear.write #= true
        for (at <- 0 until words) {
          val value = r.nextInt(65536)
          clear.writeAddress #= at
          dut.io.clearValue #= value
          dut.clockDomain.waitSampling()
          banks.foreach(_(at) = value)
        }
        clear.all #= false

        for (block <- 0 until 200) {
          // Those who draw have one bank, the resolver the other, or nothing at all.
          val mine = r.nextInt(2)
          val active = r.nextInt(4) > 0
          clear.active #= active
          clear.bank #= 1 - mine
          var known, knownResolved = false
          for (clock <- 0 until 40) {
            val at = r.shuffle((0 until words).toList) // apart: a word is not read in the clock it is written
            def chance = r.nextInt(4) > 0
            val (read, write, resolve, wipe) = (chance, chance, active && chance, chance)
            val (data, wiped) = (r.nextInt(65536), r.nextInt(65536))
            dut.io.readEnable #= read
            dut.io.readBank #= (if (read) mine else r.nextInt(2))
            dut.io.readAddress #= at(0)
            dut.io.writeEnable #= (if (write) 1 << mine else 0)
            dut.io.writeAddress #= at(1)
            dut.io.writeData #= data
            clear.read #= resolve
            clear.readAddress #= at(2)
            clear.write #= wipe
            clear.writeAddress #= at(3)
            dut.io.clearValue #= wiped
            sleep(1)
            def where = s"seed $seed block $block clock $clock"
            if (known) { reads += 1; assert(dut.io.readData.toInt == drawn, s"$where: drawn") }
            if (resolved && knownResolved) {
              resolves += 1; assert(dut.io.resolvedData.toInt == shown, s"$where: resolved")
            }
            dut.clockDomain.waitSampling()
            if (read) { drawn = banks(mine)(at(0)); known = true }
            if (resolve) { shown = banks(1 - mine)(at(2)); knownResolved = true }
            if (write) banks(mine)(at(1)) = data
            if (wipe && active) banks(1 - mine)(at(3)) = wiped
          }
        }
        assert(reads > 5000 && (!resolved || resolves > 4000))
      }
    }
}
