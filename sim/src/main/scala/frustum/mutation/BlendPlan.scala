package frustum.mutation

import frustum.contract.raster.RasterConfig
import frustum.device.Tech
import frustum.model
import frustum.raster.fragment.Blend
import scala.util.Random

/** Blending, as `BlendTest` has it: tiles of a few and of all pixels, blended and replaced, over different clear
  * colours, swept while the next tile is drawn.
  */
object BlendPlan {
  private val config = RasterConfig(19, 21, 3, 3)
  private val words = config.tileWidth * config.tileHeight

  def apply(seed: Long): MutationPlan = {
    val r = new Random(seed)
    val time = new Timeline
    var t = 0
    var mixed = 0L // whether what entered a clock ago goes on

    /** What enters at `t`: port values; whether it is to be written; whether it is the mark. */
    def enter(f: Option[Map[String, Long]], passed: Boolean, mark: Boolean, bank: Int): Unit = {
      val valid = if (f.isDefined) 1L else 0L
      time.drive(t, "io_up_valid" -> valid)
      time.drive(t, f.getOrElse(Map.empty).map { case (p, v) => s"io_up_payload_$p" -> v }.toSeq: _*)
      time.drive(t + 1, "io_passed" -> (if (passed) 1L else 0L))
      time.expect(t + 1, "io_busy" -> (valid | mixed))
      mixed = if (passed) valid else 0
      time.expect(t + 2, "io_tileEnd_valid" -> (if (mark) 1L else 0L))
      if (mark) time.expect(t + 2, "io_tileEnd_payload" -> bank.toLong)
      t += 1
    }
    def idle(clocks: Int): Unit = for (_ <- 0 until clocks) enter(None, r.nextBoolean(), mark = false, 0)

    for (blend <- Seq(false, true); clear <- Seq(0, 0xffff, 0xa5b7)) {
      val start = t
      time.sweep(t, words, None)((_, _) => ())
      idle(2 * words + 1)
      var cleared = t
      // Each bank is drawn all over while the other is swept.
      for ((places, n) <- Seq(4, words, words, 5, words, words).zipWithIndex) {
        val bank = n % 2
        val buffer = Array.fill(words)(clear)
        for (at <- BlendPlan.places(r, places, if (blend) 3 else 2, 180)) {
          if (r.nextInt(5) == 0) idle(1)
          if (t > cleared && r.nextInt(8) == 0) {
            idle(2)
            time.hold(t, bank)
            idle(1)
          }
          val (color, a, passed) =
            (BlendPlan.color(r), Seq(0, 31, r.nextInt(32))(r.nextInt(3)), r.nextInt(4) > 0)
          enter(Some(payload(at, bank, color, a, mark = false)), passed, mark = false, bank)
          if (passed) buffer(at) = if (blend) model.raster.fragment.Blend(color, buffer(at), a) else color
        }
        // Marks are never blended away, whatever their alpha.
        enter(
          Some(payload(r.nextInt(words), bank, BlendPlan.color(r), r.nextInt(32), mark = true)),
          passed = true,
          mark = true,
          bank
        )
        cleared = time.sweep(t + 2, words, Some(bank))((clock, a) =>
          time.expect(clock, "io_color" -> buffer(a).toLong)
        )
      }
      idle(2 * words + 8)
      for (clock <- start until t)
        time.drive(clock, "io_state_blend" -> (if (blend) 1L else 0L), "io_clearColor" -> clear.toLong)
    }
    val loose = Seq("address" -> 6, "bank" -> 1, "r" -> 5, "g" -> 6, "b" -> 5, "a" -> 5, "tileEnd" -> 1)
    MutationPlan(
      "Blend",
      () => Blend(config, Tech.Generic),
      time.steps(r, loose.map { case (f, bits) => s"io_up_payload_$f" -> bits } ++ Timeline.idleClear(6))
    )
  }

  private def payload(at: Int, bank: Int, color: Int, a: Int, mark: Boolean): Map[String, Long] = Map(
    "address" -> at.toLong,
    "bank" -> bank.toLong,
    "r" -> (color >> 11).toLong,
    "g" -> (color >> 5 & 63).toLong,
    "b" -> (color & 31).toLong,
    "a" -> a.toLong,
    "tileEnd" -> (if (mark) 1L else 0L)
  )

  /** The next place, not among the last ones: the interlock keeps fragments of a pixel as many clocks apart. */
  def places(r: Random, of: Int, apart: Int, count: Int): Seq[Int] =
    Iterator.iterate(Vector(0)) { last =>
      last.takeRight(apart - 1) :+
        Iterator.continually(r.nextInt(of)).find(!last.takeRight(apart - 1).contains(_)).get
    }.map(_.last).take(count).toSeq

  def color(r: Random): Int = Seq(0, 0xffff, r.nextInt(65536))(r.nextInt(3))
}
