package frustum.demos.pong

import frustum.contract.video.{ColorFormat, VideoMode}
import frustum.harness.{FrustumSim, Simulated}
import frustum.model.demos.pong.{PongButtons => Pressed, PongGame, PongModel}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import spinal.lib.graphic.vga.VgaTimings

import scala.collection.mutable.ArrayBuffer

class PongPipelineTest extends AnyFunSuite with Simulated {

  /** The game's own field of view in fewer pixels; blanks long enough for set-up. */
  private val mode =
    VideoMode("256x96", 25.175, 256, 96, 16, 96, 400, 10, 2, 33, hPositive = true, vPositive = false)

  test("pictures at the pins equal the model's, and change with the game's ticks alone") {
    for ((format, frames) <- Seq(ColorFormat.Rgb444 -> 8, ColorFormat.Rgb332 -> 2, ColorFormat.Rgb888 -> 2)) {
      val config = PongPipelineConfig(mode, format, PongScene.room(256, 96, 3))
      val model = new PongModel(config)
      // Registers hold something else at each power up.
      val boots = if (format == ColorFormat.Rgb888) 5 to 8 else Seq(5)
      val unit = FrustumSim.compile(s"PongPipeline_${format.name}")(PongPipeline(config))
      for (boot <- boots) unit.doSim("frames", boot) { dut =>
        SimTimeout(1000L * 1000 * 1000)
        dut.io.buttons.up #= true
        dut.io.buttons.down #= false
        dut.io.buttons.left #= true
        dut.io.buttons.right #= false
        val pixels = ArrayBuffer[Int]()
        dut.clockDomain.onSamplings {
          val v = dut.io.video
          if (v.active.toBoolean)
            pixels += (v.red.toInt << format.green | v.green.toInt) << format.blue | v.blue.toInt
          else assert(v.red.toInt + v.green.toInt + v.blue.toInt == 0, "colour in the blank")
        }
        dut.clockDomain.forkStimulus(10)
        val held = Pressed(up = true, left = true)
        val games = Iterator.iterate(PongGame.start)(_.tick(held)).take(8).toIndexedSeq
        var tick = 0
        for (frame <- 0 until frames) {
          pixels.clear()
          while (pixels.size < mode.width * mode.height) dut.clockDomain.waitSampling()
          val wanted = games.drop(tick).take(2).map(model.frame(_).toSeq)
          val at = wanted.indexWhere(_ == pixels.toSeq)
          val off = wanted.head.indices.filter(i => wanted.head(i) != pixels(i))
          assert(
            at >= 0,
            s"${format.name}, boot $boot, frame $frame: ${off.size} pixels differ from tick $tick, the first at " +
              off.headOption.map(i => (i % mode.width, i / mode.width, pixels(i), wanted.head(i)))
          )
          tick += at
        }
        assert(tick == frames / 2 || tick == frames / 2 - 1, s"$tick ticks in $frames frames")
      }
    }
  }

  test("a reset in the middle of a pulse leaves no pulse behind") {
    val m = mode.copy(vPositive = true, vFront = 1)
    FrustumSim.compile("PongPipeline_reset")(PongPipeline(PongPipelineConfig(m, scene = PongScene.room(256, 96, 3))))
      .doSim("reset", 5) { dut =>
        SimTimeout(1000L * 1000 * 1000)
        Seq(dut.io.buttons.up, dut.io.buttons.down, dut.io.buttons.left, dut.io.buttons.right).foreach(_ #= false)
        def quiet(what: String) = for (clock <- 0 until m.width) {
          dut.clockDomain.waitSampling()
          assert(!dut.io.video.hSync.toBoolean && !dut.io.video.vSync.toBoolean, s"$what, clock $clock")
        }
        dut.clockDomain.forkStimulus(10)
        dut.clockDomain.waitSampling()
        quiet("from the start")
        while (!(dut.io.video.vSync.toBoolean && dut.io.video.hSync.toBoolean)) dut.clockDomain.waitSampling()
        dut.clockDomain.waitSampling(20)
        dut.clockDomain.assertReset()
        sleep(30)
        dut.clockDomain.deassertReset()
        quiet("after the reset")
      }
  }

  test("timings are those of spinal.lib") {
    FrustumSim
      .compile("VgaTimings")(new spinal.core.Component {
        val timings = spinal.core.out(VgaTimings(12))
        timings.setAs_h640_v480_r60
      })
      .doSim("read", 1) { dut =>
        sleep(1)
        val m = VideoMode.Vga640x480
        assert(dut.timings.h.syncStart.toInt == m.hSync - 1)
        assert(dut.timings.h.syncEnd.toInt == m.hTotal - 1)
        assert(dut.timings.h.colorEnd.toInt - dut.timings.h.colorStart.toInt == m.width)
        assert(dut.timings.v.syncStart.toInt == m.vSync - 1)
        assert(dut.timings.v.syncEnd.toInt == m.vTotal - 1)
        assert(dut.timings.v.colorEnd.toInt - dut.timings.v.colorStart.toInt == m.height)
        assert(dut.timings.h.colorStart.toInt == m.hSync + m.hBack - 1)
        assert(dut.timings.v.colorStart.toInt == m.vSync + m.vBack - 1)
      }
  }
}
