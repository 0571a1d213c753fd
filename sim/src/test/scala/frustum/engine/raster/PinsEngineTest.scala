package frustum.engine.raster

import frustum.command.CommandRunner
import frustum.contract.raster.RasterConfig
import frustum.contract.video.Panel
import frustum.driver.raster.Driver
import frustum.engine.EngineSim
import frustum.harness.{Simulated, ThreadTime}
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import java.nio.file.Files
import scala.util.Random

class PinsEngineTest extends AnyFunSuite with Simulated {
  private val small = RasterConfig(width = 64, height = 48)

  private def simulate(seed: Int)(body: (PinsTestbed, PinsSession) => Unit): Unit =
    EngineSim.run(PinsEngine.compile(small, Panel.Ili9341), None, seed)(dut => body(dut, new PinsSession(dut)))

  private def check(session: PinsSession, expected: Array[Int], what: String): Unit = {
    Frames.assertEqual(small, session.controller.picture(small.width, small.height), expected, what)
    assert(session.controller.violations.isEmpty, what)
  }

  private val pixels = small.width * small.height

  test("frames sent without waiting: cts holds the host back, the pictures are right") {
    val seed = 21
    val random = new Random(seed)
    val texture = Frames.texture(random)
    val passes = (0 until 5).map(Frames.random(random, small, _, 12))
    simulate(seed) { (dut, session) =>
      session.send((Driver.commands(texture) ++ passes.flatMap(Driver.commands)).flatten)
      var heldBack = false
      while (session.controller.pixels < passes.length * pixels) {
        session.run(2000)
        heldBack |= !dut.io.cts.toBoolean
      }
      assert(heldBack, "cts never fell")
      check(session, Frames.model(small, Seq(texture), Seq(passes.last)), s"seed $seed")
    }
  }

  test("the host drives the display itself; the frame after is right again") {
    val seed = 22
    val random = new Random(seed)
    val texture = Frames.texture(random)
    val pass = Frames.random(random, small, 0, 12)
    simulate(seed) { (dut, session) =>
      session.send(Driver.commands(texture).flatten, wait = true)
      session.frame(Driver.commands(pass).flatten, pixels)
      val expected = Frames.model(small, Seq(texture), Seq(pass))
      dut.io.tftMux #= true
      def write(command: Int, data: Int*): Unit = {
        dut.io.dc #= false
        session.send(Seq(command), wait = true)
        session.run(100)
        dut.io.dc #= true
        if (data.nonEmpty) session.send(data, wait = true)
        session.run(100)
      }
      write(Panel.ColumnAddress, 0, 10, 0, 11)
      write(Panel.RowAddress, 0, 5, 0, 5)
      write(Panel.MemoryWrite, 0xf8, 0x00, 0x07, 0xe0)
      dut.io.tftMux #= false
      expected(5 * small.width + 10) = 0xf800
      expected(5 * small.width + 11) = 0x07e0
      check(session, expected, "written by the host")
      val next = Frames.random(random, small, 1, 12)
      session.frame(Driver.commands(next).flatten, pixels)
      check(session, Frames.model(small, Seq(texture), Seq(next)), "the frame after")
    }
  }

  test("the reset pin in mid-frame: the display starts anew, the next whole frame is right") {
    val seed = 23
    val random = new Random(seed)
    val texture = Frames.texture(random)
    simulate(seed) { (_, session) =>
      session.send(Driver.commands(texture).flatten, wait = true)
      for (trial <- 0 until 3) {
        session.send(Driver.commands(Frames.random(random, small, 0, 12)).flatten)
        session.run(random.between(2000, 60000))
        session.reset()
        val good = Frames.random(random, small, 1, 12)
        session.frame(Driver.commands(good).flatten, pixels)
        check(session, Frames.model(small, Seq(texture), Seq(good)), s"seed $seed, trial $trial")
      }
    }
  }

  test("320 x 240 on the other panel: the picture is the model's, a frame takes less than 10 s") {
    val config = RasterConfig(width = 320, height = 240)
    PinsEngine.compile(config, Panel.St7789) // not to be counted
    val frames = Frames.scene("cube", config)
    val (seconds, drawn) = ThreadTime.of(new PinsEngine(EngineOptions(1, None, Panel.St7789)).drawAll(frames).head)
    info(f"$seconds%.1f s, ${drawn.clocksAtPins.get} clocks")
    Frames.assertEqual(config, drawn.image, Frames.model(frames.head), "cube")
    assert(seconds < 10)
  }

  test("render takes the panel asked for") {
    val folder = Files.createTempDirectory("render")
    val run = CommandRunner.run(
      "--line",
      s"render --scene cube --size 320x240 --panel st7789 --out $folder/cube.png --report $folder/cube.json"
    )
    assert(run.code == 0 && run.err.isEmpty && run.out.contains("display st7789"), run)
    val report = ujson.read(Files.readString(folder.resolve("cube.json")))
    assert(report("hardwareVsModel")("pixelsDifferent").num == 0)
  }
}
