package frustum.raster.tile

import frustum.contract.raster.RasterConfig
import frustum.harness.{Equality, FrustumSim, Simulated, Stalls}
import frustum.model.raster.FragmentModel
import frustum.video.ResolvedPixel
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import spinal.lib.sim.StreamDriver

import scala.util.Random

/** The resolver's pixels, and what it leaves in the tile memory, against the model's tiles. */
class ResolverTest extends AnyFunSuite with Simulated {
  private val seed = 12
  private case class Stroke(at: Int, color: Int, end: Boolean)
  private case class Pixel(color: Int, first: Boolean, tileX: Int, tileY: Int)

  /** Everything below its ready: clears that repeat and that do not. */
  private val clears = Seq(0x1234, 0x1234, 0xffff, 0, 0)

  private def check(config: RasterConfig, frames: Int, throughput: Double): Unit = {
    val r = new Random(seed)
    val words = config.tileWidth * config.tileHeight
    val tiles =
      for (f <- 0 until frames; y <- 0 until config.tilesY; x <- 0 until config.tilesX) yield (f, x, y)
    val strokes =
      tiles.map(_ => Seq.fill(r.nextInt(60))(Stroke(r.nextInt(words), r.nextInt(65536), end = false)))
    val model = new FragmentModel(config, Array(0))
    val screen = new Array[Int](config.width * config.height)
    // The screen is read before the next tile changes it.
    val expected = tiles.zip(strokes).flatMap { case ((f, tileX, tileY), tile) =>
      model.clear(clears(f))
      tile.foreach(s => model.color(s.at) = s.color)
      model.resolve(tileX, tileY, screen)
      val (left, top) = (tileX * config.tileWidth, tileY * config.tileHeight)
      for {
        y <- top until config.height.min(top + config.tileHeight)
        x <- left until config.width.min(left + config.tileWidth)
      } yield Pixel(screen(y * config.width + x), x == left && y == top, tileX, tileY)
    }

    def setup(dut: ResolverBench): Unit = {
      val colors = clears.take(frames).iterator
      StreamDriver(dut.io.start, dut.clockDomain)(p =>
        colors.hasNext && { p.clearColor #= colors.next(); true }
      )
      val places = tiles.iterator
      StreamDriver(dut.io.tile, dut.clockDomain) { p =>
        places.hasNext && { val (_, x, y) = places.next(); p.tileX #= x; p.tileY #= y; true }
      }
    }
    val name = s"Resolver_${config.width}x${config.height}_${config.tileWidth}x${config.tileHeight}"
    Equality(FrustumSim.compile(name)(new ResolverBench(config)))(_.io.up, _.io.pixels)(
      (p: TileStroke, s: Stroke) => { p.at #= s.at; p.color #= s.color; p.tileEnd #= s.end },
      (p: ResolvedPixel) => Pixel(p.color.toInt, p.first.toBoolean, p.tileX.toInt, p.tileY.toInt)
    ).run(
      strokes.flatMap(_ :+ Stroke(0, 0, end = true)),
      expected,
      seed,
      Seq(Stalls.Never, Stalls(0.5, 0.5), Stalls(1, 0.25)),
      Some(throughput),
      setup = setup
    )
  }

  // Of tiles on the border only a part is sent; a new clear colour takes a clock for each word of a bank.
  test("tiles of 8 x 8 on 19 x 21 pixels, five frames with three clear colours") {
    check(RasterConfig(19, 21, 3, 3), 5, 0.5)
  }
  test("tiles of 32 x 16 on 65 x 33 pixels, five frames") { check(RasterConfig(65, 33, 5, 4), 5, 0.4) }
  test("whole tiles, a pixel a clock") { check(RasterConfig(128, 96), 2, 0.97) }
}
