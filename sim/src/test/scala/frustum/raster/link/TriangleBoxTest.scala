package frustum.raster.link

import frustum.contract.raster.{PackedVertex, RasterConfig}
import frustum.harness.{FrustumSim, Simulated}
import frustum.model
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._

import scala.util.Random

/** Tiles that a triangle may touch along an axis, against the model. */
class TriangleBoxTest extends AnyFunSuite with Simulated {
  private val seed = 14

  for (config <- Seq(RasterConfig(8, 8, 3, 3), RasterConfig(), RasterConfig(1001, 509, 5, 4)))
    test(s"${config.width} x ${config.height} pixels, tiles of ${config.tileWidth} x ${config.tileHeight}") {
      FrustumSim.compile(s"TriangleBox_${config.width}x${config.height}")(TriangleBox(config)).doSim(seed) {
        dut =>
          val r = new Random(seed)
          dut.io.clear #= false
          dut.io.coordinate.valid #= false
          dut.clockDomain.forkStimulus(10)
          dut.clockDomain.waitSampling()
          var boxes, empties = 0
          for (n <- 0 until 3000) {
            val vertical = r.nextBoolean()
            val (limit, log2) =
              if (vertical) (config.height, config.tileLog2Height) else (config.width, config.tileLog2Width)
            def any = r.between(-PackedVertex.MaxXy, PackedVertex.MaxXy + 1)
            def screen = r.between(-40, 16 * limit + 40)
            def border = Seq(0, 16 * limit, 16 << log2)(r.nextInt(3)) + r.between(-10, 11)
            val near = screen
            val off = if (r.nextBoolean()) r.between(-PackedVertex.MaxXy, -8)
            else r.between(16 * limit - 7, PackedVertex.MaxXy)
            val c = Seq.fill(3)(n % 5 match {
              case 0 => any
              case 1 => screen
              case 2 => border
              case 3 => near + r.between(-9, 10)
              case _ => off + r.between(0, 8) // often no centre on the screen
            }).map(_.min(PackedVertex.MaxXy))

            dut.io.vertical #= vertical
            dut.io.clear #= true
            dut.clockDomain.waitSampling()
            dut.io.clear #= false
            for (v <- c) {
              val gap = if (n % 3 == 0) 0 else r.nextInt(4)
              dut.clockDomain.waitSampling(gap)
              dut.io.coordinate.valid #= true
              dut.io.coordinate.payload #= v
              dut.clockDomain.waitSampling()
              dut.io.coordinate.valid #= false
              dut.io.coordinate.payload #= any
            }
            dut.clockDomain.waitSampling(5)
            val (first, end) = model.raster.link.TriangleBox.pixels(c, limit)
            def where = s"seed $seed triangle $n, $c, vertical $vertical"
            assert(dut.io.empty.toBoolean == (first >= end), where)
            if (first < end) {
              val got = if (vertical) (dut.io.firstY.toInt, dut.io.lastY.toInt)
              else (dut.io.firstX.toInt, dut.io.lastX.toInt)
              assert(got == (first >> log2, (end - 1) >> log2), where)
              boxes += 1
            } else empties += 1
          }
          assert(boxes > 500 && empties > 500, s"$boxes boxes, $empties empty")
      }
    }
}
