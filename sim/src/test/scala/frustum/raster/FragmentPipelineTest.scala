package frustum.raster

import frustum.contract.raster.{DepthFunction, RasterConfig, RenderState}
import frustum.device.Tech
import frustum.harness.{Equality, FrustumSim, Simulated, Stalls}
import frustum.model.raster.fragment.{Fragment => FragmentValues}
import frustum.model.raster.FragmentModel
import frustum.raster.fragment.StateSim
import frustum.raster.scan.InterpolatedFragment
import frustum.raster.tile.TilePosition
import frustum.video.ResolvedPixel
import org.scalatest.funsuite.AnyFunSuite
import spinal.core.sim._
import spinal.lib.sim.StreamDriver

import scala.collection.mutable
import scala.util.Random

/** One thing that enters the pipeline: a fragment, or the end of a tile. */
case class Item(tileEnd: Boolean, values: FragmentValues)

/** A pixel that leaves it. */
case class Pixel(color: Int, first: Boolean, tileX: Int, tileY: Int)

class FragmentPipelineTest extends AnyFunSuite with Simulated {

  /** Fragments of all tiles of a frame: `perTile` each, drawn by `pick`. */
  def frame(config: RasterConfig, perTile: Int, pick: FragmentValues => Unit): Seq[Item] =
    (0 until config.tilesX * config.tilesY).flatMap { _ =>
      Seq.fill(perTile) { val f = new FragmentValues; pick(f); Item(tileEnd = false, f) } :+ Item(
        tileEnd = true,
        new FragmentValues
      )
    }

  def anywhere(config: RasterConfig, random: Random)(f: FragmentValues): Unit = {
    f.x = random.nextInt(config.tileWidth)
    f.y = random.nextInt(config.tileHeight)
    f.s = random.nextInt() >> random.nextInt(10)
    f.t = random.nextInt() >> random.nextInt(10)
    f.q = random.nextInt() >>> 1 + random.nextInt(12)
    f.z = if (random.nextInt(4) == 0) random.nextInt() else random.nextInt(4) << 15 + random.nextInt(12)
    f.r = random.nextInt(65536) - 32768
    f.g = random.nextInt(65536) - 32768
    f.b = random.nextInt(65536) - 32768
    f.a = random.nextInt(65536) - 32768
  }

  /** Only the pixels 0 and 1 of the tile: hazards at every distance. */
  def hammer(config: RasterConfig, random: Random)(f: FragmentValues): Unit = {
    anywhere(config, random)(f)
    f.x = random.nextInt(2)
    f.y = 0
  }

  def expected(
      config: RasterConfig,
      clears: Seq[Int],
      items: Seq[Item],
      state: RenderState,
      texels: Array[Int]
  ): Seq[Pixel] = {
    val model = new FragmentModel(config, texels)
    val out = mutable.ArrayBuffer.empty[Pixel]
    val image = new Array[Int](config.width * config.height)
    var tile = 0
    var count = 0
    model.clear(clears.head)
    for (item <- items)
      if (!item.tileEnd) model.draw(item.values, state)
      else {
        val (x, y) = (tile % config.tilesX, tile / config.tilesX)
        model.resolve(x, y, image)
        val (left, top) = (x * config.tileWidth, y * config.tileHeight)
        for (
          row <- top until config.height.min(top + config.tileHeight);
          column <- left until config.width.min(left + config.tileWidth)
        )
          out += Pixel(image(row * config.width + column), row == top && column == left, x, y)
        count += 1
        tile = count % (config.tilesX * config.tilesY)
        model.clear(clears(count / (config.tilesX * config.tilesY) % clears.length))
      }
    out.toSeq
  }

  def drive(p: InterpolatedFragment, item: Item): Unit = {
    val f = item.values
    p.x #= f.x; p.y #= f.y; p.s #= f.s; p.t #= f.t; p.q #= f.q; p.z #= f.z
    p.r #= f.r; p.g #= f.g; p.b #= f.b; p.a #= f.a
    p.tileEnd #= item.tileEnd
  }
  def read(p: ResolvedPixel): Pixel = Pixel(p.color.toInt, p.first.toBoolean, p.tileX.toInt, p.tileY.toInt)

  /** Loads texels, then starts frame after frame, with the clear colours in turn. */
  def prepare(config: RasterConfig, clears: Seq[Int], state: RenderState, texels: Array[Int])(
      dut: FragmentHarness
  ): Unit = {
    StateSim.drive(dut.io.state, state)
    var tile = 0
    StreamDriver(dut.io.tile, dut.clockDomain) { p: TilePosition =>
      p.tileX #= tile % config.tilesX
      p.tileY #= tile / config.tilesX
      tile = (tile + 1) % (config.tilesX * config.tilesY)
      true
    }
    val load = texels.indices.iterator
    StreamDriver(dut.io.texels, dut.clockDomain) { p =>
      load.hasNext && { val i = load.next(); p.address #= i; p.data #= texels(i); true }
    }.transactionDelay = () => 0
    var started = 0
    StreamDriver(dut.io.start, dut.clockDomain) { p =>
      val go = !load.hasNext
      if (go) { p.clearColor #= clears(started % clears.length); started += 1 }
      go
    }
  }

  val small = RasterConfig(19, 21, 3, 3, textureTexels = 256)
  lazy val compiledSmall = FrustumSim.compile("FragmentPipeline_small")(new FragmentHarness(small))
  val odd = RasterConfig(65, 33, 5, 4, textureTexels = 1024)
  lazy val compiledOdd = FrustumSim.compile("FragmentPipeline_odd")(new FragmentHarness(odd))

  def check(
      config: RasterConfig,
      seed: Int,
      state: RenderState,
      items: Seq[Item],
      stalls: Seq[Stalls] = Stalls.All,
      throughput: Option[Double] = None,
      colors: Int = 1
  ): Unit = {
    val random = new Random(seed + 1000)
    val texels = Array.fill(config.textureTexels)(random.nextInt(65536))
    val clears = Seq.fill(colors)(random.nextInt(65536))
    Equality(if (config == small) compiledSmall else compiledOdd)(_.io.up, _.io.pixels)(drive, read).run(
      items,
      expected(config, clears, items, state, texels),
      seed,
      stalls,
      throughput,
      setup = prepare(config, clears, state, texels),
      done = dut => assert(!dut.io.busy.toBoolean, s"seed $seed: still busy")
    )
  }

  for (seed <- 1 to 8) test(s"random states and fragments, 8 x 8 tiles, seed $seed") {
    val random = new Random(seed)
    check(small, seed, StateSim.random(random, 256), frame(small, 100, anywhere(small, random)))
  }
  for (seed <- 1 to 3) test(s"random states and fragments, 32 x 16 tiles, odd screen, seed $seed") {
    val random = new Random(seed)
    check(
      odd,
      seed,
      StateSim.random(random, 1024),
      frame(odd, 600, anywhere(odd, random)),
      Seq(Stalls.Never, Stalls(0.7, 0.4))
    )
  }
  for (blend <- Seq(false, true)) test(s"hazard hammer, blend = $blend") {
    val random = new Random(9)
    val state = RenderState(depth = DepthFunction.LessEq, blend = blend)
    check(small, 9, state, frame(small, 300, hammer(small, random)))
  }
  test("empty tiles show the clear colour, tile after tile") {
    check(small, 10, RenderState(), frame(small, 0, _ => ()) ++ frame(small, 0, _ => ()))
  }
  test("frames follow each other, with the same clear colour and with others") {
    val random = new Random(12)
    val items = Seq.fill(4)(frame(small, 60, anywhere(small, random))).flatten
    check(small, 12, RenderState(blend = true), items)
    check(small, 13, RenderState(blend = true), items, colors = 3)
  }
  test("one fragment a clock") {
    val items = frame(odd, 2048, _ => ())
      .grouped(2049)
      .flatMap { tile =>
        tile.init.zipWithIndex.foreach { case (item, i) =>
          item.values.x = i % 32; item.values.y = i / 32 % 16; item.values.q = 1 << 30
        }
        tile
      }
      .toSeq
    check(
      odd,
      11,
      RenderState(depth = DepthFunction.LessEq, blend = true),
      items,
      Seq(Stalls.Never),
      Some(0.92)
    )
  }
  test("a full tile is drawn while the one before is resolved: 0.9 fragments a clock and more") {
    val perTile = odd.tileWidth * odd.tileHeight
    var i = 0
    def everywhere(f: FragmentValues): Unit = {
      f.x = i % odd.tileWidth; f.y = i / odd.tileWidth % odd.tileHeight; f.q = 1 << 30
      i += 1
    }
    val items = Seq.fill(2)(frame(odd, perTile, everywhere)).flatten
    check(odd, 14, RenderState(depth = DepthFunction.LessEq), items, Seq(Stalls.Never), Some(0.9))
  }
}
