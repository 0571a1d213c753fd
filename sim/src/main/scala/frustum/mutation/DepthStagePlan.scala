package frustum.mutation

import frustum.contract.raster.{DepthFunction, RasterConfig, RenderState}
import frustum.model
import frustum.raster.fragment.DepthStage
import scala.util.Random

/** The depth test, as `DepthTestTest` has it: every function, written and not, tile after tile, with depths that meet.
  */
object DepthStagePlan {
  private val config = RasterConfig(19, 21, 3, 3)
  private val words = config.tileWidth * config.tileHeight

  def apply(seed: Long): MutationPlan = {
    val r = new Random(seed)
    val time = new Timeline
    val depth = new model.raster.fragment.DepthStage(words)
    var (t, bank) = (time.sweep(0, words, None)((_, _) => ()), 0)

    /** What enters at `t`. */
    def enter(f: Option[DepthItem], state: RenderState): Unit = {
      val valid = if (f.isDefined) 1L else 0L
      time.drive(t, "io_up_valid" -> valid)
      time.expect(t, "io_down_valid" -> valid)
      time.expect(t + 1, "io_busy" -> valid)
      time.drive(t + 1, "io_z" -> f.fold(r.nextInt(65536))(_.z).toLong)
      for (i <- f) {
        val channels =
          Seq("r" -> r.nextInt(32), "g" -> r.nextInt(64), "b" -> r.nextInt(32), "a" -> r.nextInt(32))
            .map { case (c, v) => c -> v.toLong } :+ "tileEnd" -> (if (i.end) 1L else 0L)
        time.drive(t, channels.map { case (c, v) => s"io_up_payload_$c" -> v }: _*)
        time.drive(
          t,
          "io_up_payload_x" -> (i.at % config.tileWidth).toLong,
          "io_up_payload_y" -> (i.at / config.tileWidth).toLong
        )
        time.expect(t, channels.map { case (c, v) => s"io_down_payload_$c" -> v }: _*)
        time.expect(t, "io_down_payload_address" -> i.at.toLong, "io_down_payload_bank" -> bank.toLong)
        time.expect(t + 1, "io_passed" -> (if (i.end || depth(i.at, i.z, state)) 1L else 0L))
      }
      t += 1
    }

    // Three tiles for each state, so that both banks see all kinds.
    for {
      function <- 0 to 7
      write <- Seq(true, false)
      items <- Seq(DepthItem.close(r, 200), DepthItem.far(r, 200), DepthItem.far(r, 200))
    } {
      val state = RenderState(depth = DepthFunction.decode(function), depthWrite = write)
      val start = t
      for ((i, n) <- items.zipWithIndex) {
        if (r.nextInt(4) == 0) enter(None, state)
        if (n > 150 && r.nextInt(8) == 0) { // the other bank is clear again
          enter(None, state)
          time.hold(t, bank)
          enter(None, state)
        }
        enter(Some(i), state)
      }
      enter(Some(DepthItem(0, r.nextInt(65536), end = true)), state)
      depth.clear()
      for (clock <- start to t)
        time.drive(
          clock,
          "io_state_depthFunction" -> function.toLong,
          "io_state_depthWrite" -> (if (write) 1L else 0L)
        )
      time.sweep(t + 1, words, Some(bank))((_, _) => ())
      bank = 1 - bank
      Seq.fill(3)(enter(None, state))
    }
    // Both banks full of what was drawn, then cleared at once.
    val dirty = RenderState(depth = DepthFunction.Always, depthWrite = true)
    for (_ <- 0 to 1) {
      val start = t
      for (at <- 0 until words) enter(Some(DepthItem(at, r.nextInt(65536), end = false)), dirty)
      enter(Some(DepthItem(0, 0, end = true)), dirty)
      bank = 1 - bank
      enter(None, dirty)
      for (clock <- start to t) time.drive(clock, "io_state_depthFunction" -> 7, "io_state_depthWrite" -> 1)
    }
    depth.clear()
    val swept = time.sweep(t, words, None)((_, _) => ())
    val less = RenderState(depth = DepthFunction.Less)
    while (t < swept) enter(None, less)
    for (_ <- 0 to 1) {
      val start = t
      for (at <- 0 until words) enter(Some(DepthItem(at, r.nextInt(65536), end = false)), less)
      enter(Some(DepthItem(0, 0, end = true)), less)
      depth.clear()
      bank = 1 - bank
      enter(None, less)
      for (clock <- start to t) time.drive(clock, "io_state_depthFunction" -> 1, "io_state_depthWrite" -> 1)
    }
    val loose = Seq("x" -> 3, "y" -> 3, "r" -> 5, "g" -> 6, "b" -> 5, "a" -> 5, "tileEnd" -> 1)
    MutationPlan(
      "DepthTest",
      () => DepthStage(config),
      time.steps(r, loose.map { case (f, bits) => s"io_up_payload_$f" -> bits } ++ Timeline.idleClear(6))
    )
  }
}

/** A fragment for the depth test, or the mark that ends the tile. */
final case class DepthItem(at: Int, z: Int, end: Boolean)

object DepthItem {

  /** Never the same place twice in a row, which the interlock sees to. */
  private def items(r: Random, places: Seq[Int]): Seq[DepthItem] = places.map(at =>
    DepthItem(
      at,
      if (r.nextBoolean()) r.nextInt(3) + 32767 else Seq(0, 65535, r.nextInt(65536))(r.nextInt(3)),
      end = false
    )
  )

  /** All over a tile of 64 pixels. */
  def far(r: Random, count: Int): Seq[DepthItem] =
    items(r, Seq.iterate(r.nextInt(64), count)(at => (at + 1 + r.nextInt(63)) & 63))

  /** On three pixels. */
  def close(r: Random, count: Int): Seq[DepthItem] =
    items(r, Seq.iterate(r.nextInt(3), count)(at => (at + 1 + r.nextInt(2)) % 3))
}
